#include "formulations/verification/run/submodels.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>

#include "formulations/model/plan.h"

namespace desmo {

namespace {

/// Returns the entities that move, in sets that no equation joins.
std::vector<std::vector<EntityId>> independent_entities(const Model& m) {
  std::vector<EntityId> next(m.entities.size());  // one that it is joined to; itself: the last one
  std::iota(next.begin(), next.end(), 0);
  const auto last = [&next](EntityId e) {
    while (next[e] != e) e = next[e] = next[next[e]];
    return e;
  };
  for (const Constraint& c : m.constraints) {
    EntityId first = no_position;
    for (const EntityId e : c.operands) {
      if (m.is_at_rest(e)) continue;
      if (first == no_position)
        first = e;
      else
        next[last(e)] = last(first);
    }
  }
  std::map<EntityId, std::vector<EntityId>> sets;
  for (EntityId e = 0; e < static_cast<EntityId>(m.entities.size()); ++e)
    if (!m.is_at_rest(e)) sets[last(e)].push_back(e);
  std::vector<std::vector<EntityId>> result;
  for (auto& [_, entities] : sets) result.push_back(std::move(entities));
  return result;
}

/// Returns the model of these entities and of all that never moves.
Submodel submodel_of(const Model& whole, std::span<const EntityId> moving,
                     std::span<const Level> levels) {
  std::vector<Output> kept;
  for (const EntityId e : moving) kept.push_back({e, Level::acceleration});
  for (EntityId e = 0; e < static_cast<EntityId>(whole.entities.size()); ++e)
    if (whole.is_at_rest(e)) kept.push_back({e, Level::acceleration});
  Plan plan = make_plan(whole, kept);
  Submodel made;
  made.model = std::move(plan.model);
  made.coordinates.resize(made.model.coordinates());
  made.groups.resize(made.model.groups.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const Entity &from = whole.entities[kept[k].entity],
                 &to = made.model.entities[plan.outputs[k].entity];
    if (to.fixed) continue;
    std::iota(made.coordinates.begin() + to.first, made.coordinates.begin() + to.first + to.size,
              from.first);
    made.groups[to.group] = from.group;
  }
  for (int c = 0; c < static_cast<int>(whole.constraints.size()); ++c)  // in the same order
    if (const std::size_t own = made.constraints.size();
        own < made.model.constraints.size() &&
        made.model.constraints[own].name == whole.constraints[c].name) {
      made.constraints.push_back(c);
      if (const GroupId group = made.model.constraints[own].group; group != no_position)
        made.groups[group] = whole.constraints[c].group;
    }
  if (!levels.empty())
    for (const int i : made.coordinates) made.levels.push_back(levels[i]);
  return made;
}

}  // namespace

std::vector<Submodel> independent_submodels(const Model& m, std::span<const Level> levels) {
  std::vector<Submodel> result;
  const std::vector<std::vector<EntityId>> sets = independent_entities(m);
  if (sets.size() < 2) return result;
  for (const std::vector<EntityId>& moving : sets) result.push_back(submodel_of(m, moving, levels));
  return result;
}

}  // namespace desmo
