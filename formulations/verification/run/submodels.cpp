#include "formulations/verification/run/submodels.h"

#include <algorithm>
#include <set>
#include <utility>

#include "cases/mechanism/disjoint_sets.h"

namespace desmo {

namespace {

/// Returns the first operand that moves; no_position: none does.
EntityId moving_operand(const Model& m, const Constraint& c) {
  const auto moving =
      std::ranges::find_if(c.operands, [&](EntityId e) { return !m.is_at_rest(e); });
  return moving == c.operands.end() ? no_position : *moving;
}

/// Returns for each entity the number of its set; no_position: it is at rest. No equation joins
/// moving entities of two sets.
std::vector<int> independent_sets(const Model& m) {
  const auto entities = static_cast<EntityId>(m.entities.size());
  DisjointSets joined(m.entities.size());
  for (const Constraint& c : m.constraints)
    for (const EntityId e : c.operands)
      if (!m.is_at_rest(e)) joined.unite(e, moving_operand(m, c));
  std::vector<int> set(m.entities.size(), no_position);
  int count = 0;
  for (EntityId e = 0; e < entities; ++e)
    if (!m.is_at_rest(e) && joined.find(e) == e) set[e] = count++;
  for (EntityId e = 0; e < entities; ++e)
    if (!m.is_at_rest(e)) set[e] = set[joined.find(e)];
  return set;
}

/// Returns the fixed points that are farthest out along each axis. With them nominal_size() of a
/// submodel includes the whole ground.
std::vector<EntityId> outermost_fixed_points(const Model& m) {
  std::vector<EntityId> points, outermost;
  for (EntityId e = 0; e < static_cast<EntityId>(m.entities.size()); ++e)
    if (m.entities[e].fixed && m.entities[e].kind == EntityKind::point) points.push_back(e);
  for (int i = 0; !points.empty() && i < m.entities[points.front()].size; ++i) {
    const auto [lowest, highest] = std::ranges::minmax(
        points, {}, [&](EntityId e) { return m.fixed_values[m.entities[e].first + i]; });
    outermost.insert(outermost.end(), {lowest, highest});
  }
  return outermost;
}

/// Returns the members of each submodel.
std::vector<Members> independent_members(const Model& m) {
  const std::vector<int> set = independent_sets(m);
  std::vector<Members> all(set.empty() ? 0 : std::ranges::max(set) + 1);
  const auto add = [&all](int of, std::vector<int> Members::*list, int member) {
    if (of != no_position)
      (all[of].*list).push_back(member);
    else
      for (Members& each : all) (each.*list).push_back(member);
  };
  const std::vector<bool> is_driven = independent_coordinates(m);
  std::vector<std::set<int>> solving(m.groups.size());  // sets that have unknowns of each group
  for (EntityId e = 0; e < static_cast<EntityId>(m.entities.size()); ++e) {
    const Entity& entity = m.entities[e];
    if (entity.fixed) continue;
    add(set[e], &Members::entities, e);
    if (set[e] != no_position && !is_driven[entity.first]) solving[entity.group].insert(set[e]);
  }
  for (const EntityId e : outermost_fixed_points(m)) add(no_position, &Members::entities, e);
  for (int d = 0; d < static_cast<int>(m.drivers.size()); ++d)
    add(set[m.drivers[d].coordinate], &Members::drivers, d);
  for (int c = 0; c < static_cast<int>(m.constraints.size()); ++c) {
    const Constraint& constraint = m.constraints[c];
    const EntityId moving = moving_operand(m, constraint);
    const std::set<int>& solvers = solving[constraint.group];
    if (moving != no_position)
      add(set[moving], &Members::constraints, c);
    else if (solvers.empty() || !is_constant(m, constraint))
      add(no_position, &Members::constraints, c);
    else  // between constants: it goes with its group
      for (const int of : solvers) add(of, &Members::constraints, c);
  }
  for (auto& [entities, constraints, drivers] : all) {
    for (const int c : constraints)
      entities.insert(entities.end(), m.constraints[c].operands.begin(),
                      m.constraints[c].operands.end());
    std::ranges::sort(entities);
    entities.erase(std::ranges::unique(entities).begin(), entities.end());
  }
  return all;
}

}  // namespace

std::vector<Submodel> independent_submodels(const Model& m, std::span<const Level> levels) {
  std::vector<Members> all = independent_members(m);
  std::vector<Submodel> result;
  if (all.size() < 2) return result;
  for (Members& members : all) {
    Submodel made{model_of(m, members), std::move(members), {}, {}, {}};
    made.groups = groups_of(m, made.members);
    for (const EntityId e : made.members.entities)
      for (int i = 0; !m.entities[e].fixed && i < m.entities[e].size; ++i)
        made.coordinates.push_back(m.entities[e].first + i);
    if (!levels.empty())
      for (const int i : made.coordinates) made.levels.push_back(levels[i]);
    result.push_back(std::move(made));
  }
  return result;
}

}  // namespace desmo
