#include "formulations/partition.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace desmo {

namespace {

void require_solution_order(const Mechanism& m) {
  for (const Constraint& c : m.constraints)
    for (const EntityId e : c.operands)
      if (m.entities[e].group > c.group)
        throw std::invalid_argument(m.name + ", group '" + m.groups[c.group].name +
                                    "': constraint '" + c.name + "' needs '" + m.entities[e].name +
                                    "', which a later group finds");
}

}  // namespace

std::vector<PartDefinition> make_partition(const Mechanism& m, Partition partition) {
  require_solution_order(m);
  std::vector<PartDefinition> constant, moving;
  std::vector<std::pair<bool, std::size_t>> part_of;  // of each group: constant?, position
  for (GroupId g = 0; g < static_cast<GroupId>(m.groups.size()); ++g) {
    const bool is_constant = m.groups[g].constant;
    std::vector<PartDefinition>& parts = is_constant ? constant : moving;
    if (is_constant || partition == Partition::group || parts.empty())
      parts.push_back({{}, {}, {}, is_constant});
    parts.back().groups.push_back(g);
    part_of.emplace_back(is_constant, parts.size() - 1);
  }
  const auto part = [&](GroupId g) -> PartDefinition& {
    const auto [is_constant, position] = part_of[g];
    return is_constant ? constant[position] : moving[position];
  };

  const std::vector<bool> independent = independent_coordinates(m);
  for (const Entity& e : m.entities)
    for (int i = e.first; !e.fixed && i < e.first + e.size; ++i)
      if (!independent[i]) part(e.group).unknowns.push_back(i);
  for (std::size_t c = 0; c < m.constraints.size(); ++c)
    part(m.constraints[c].group).equations.push_back(static_cast<int>(c));
  for (PartDefinition& p : moving) std::ranges::sort(p.unknowns);

  constant.insert(constant.end(), std::make_move_iterator(moving.begin()),
                  std::make_move_iterator(moving.end()));
  return constant;
}

std::vector<bool> constant_coordinates(const Mechanism& m) {
  std::vector<bool> result(m.coordinates(), false);
  for (const Entity& e : m.entities)
    if (!e.fixed && m.groups[e.group].constant)
      for (int i = 0; i < e.size; ++i) result[e.first + i] = true;
  return result;
}

std::vector<int> constraint_of_row(const Mechanism& m, const PartDefinition& part) {
  std::vector<int> result;
  for (const int c : part.equations) result.insert(result.end(), rows(m.constraints[c]), c);
  return result;
}

}  // namespace desmo
