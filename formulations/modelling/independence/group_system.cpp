#include "formulations/modelling/independence/group_system.h"

namespace desmo {

namespace {

std::vector<GroupSystem> list_columns(const Model& m) {
  const std::vector<bool> independent = independent_coordinates(m);
  std::vector<GroupSystem> systems(m.groups.size());
  for (GroupId g = 0; g < static_cast<GroupId>(systems.size()); ++g) systems[g].group = g;
  std::vector<std::vector<int>> drivers(m.groups.size());
  for (const Entity& e : m.entities)
    for (int i = e.first; !e.fixed && i < e.first + e.size; ++i)
      (independent[i] ? drivers[e.group] : systems[e.group].columns).push_back(i);
  for (GroupSystem& s : systems) {
    s.unknowns = static_cast<int>(s.columns.size());
    s.columns.insert(s.columns.end(), drivers[s.group].begin(), drivers[s.group].end());
  }
  return systems;
}

}  // namespace

std::vector<GroupSystem> group_systems(const Model& m) {
  std::vector<GroupSystem> systems = list_columns(m);
  int c = 0;
  for (GroupSystem& s : systems) {
    s.first_constraint = c;
    while (c < static_cast<int>(m.constraints.size()) && m.constraints[c].group == s.group) ++c;
    s.end_constraint = c;
    list_rows(m, s);
  }
  return systems;
}

void list_rows(const Model& m, GroupSystem& s) {
  s.rows.clear();
  for (int c = s.first_constraint; c < s.end_constraint; ++c)
    for (int r = 0; r < rows(m.constraints[c]); ++r) s.rows.emplace_back(c, r);
}

}  // namespace desmo
