#include "formulations/model/locking.h"

#include <algorithm>

namespace desmo {

namespace {

/// Returns whether the slopes of a block's equations by its unknowns stay the same when these
/// change.
bool is_linear(const Model& m, const PartDefinition& block, ScalarState<double>& drawn) {
  const std::vector<double> before = PartSystem<double>(m, block, drawn).jacobian;
  for (std::size_t k = 0; k < block.unknowns.size(); ++k) drawn.q[block.unknowns[k]] += k + 1;
  const std::vector<double> after = PartSystem<double>(m, block, drawn).jacobian;
  for (const int i : block.unknowns) drawn.q[i] = m.estimate[i];
  return after == before;
}

}  // namespace

bool may_lock(const Model& m, const PartDefinition& block, const std::vector<EntityId>& owner,
              ScalarState<double>& drawn) {
  const auto is_geometric = [&](int coordinate) {
    const EntityKind kind = m.entities[owner[coordinate]].kind;
    return kind == EntityKind::point || kind == EntityKind::vector;
  };
  if (std::ranges::none_of(block.unknowns, is_geometric)) return false;
  if (m.groups[block.groups.front()].bodies.size() == 1) return !is_linear(m, block, drawn);
  return !std::ranges::all_of(
      block.equations, [&](const Equation& e) { return is_linear(m.constraints[e.constraint]); });
}

}  // namespace desmo
