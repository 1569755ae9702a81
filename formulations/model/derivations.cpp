// Derivations of a model and of its parts: declared in model.h and partition.h.

#include <cmath>
#include <utility>

#include "formulations/base/index_range.h"
#include "formulations/model/incidence.h"
#include "formulations/model/partition.h"

namespace desmo {

namespace {

/// Returns whether ∂Φ/∂e of a constraint is diagonal with entries ±1, where e is the entity that it
/// derives. size: number of components of e.
bool is_explicit(const Constraint& c, int size) {
  bool result = true;
  int entries = 0;
  visit_entries(c, [&](int row, int operand, int component, double value) {
    if (operand != c.derives) return;
    ++entries;
    result = result && row == component && std::abs(value) == 1;
  });
  return result && entries == rows(c) && entries == size;
}

/// Returns for each entity whether it is among `ends`, or one of these is derived from it.
/// deriving: by entity, the constraint that derives it; no_position: none
std::vector<bool> ends_and_sources(const Model& m, const std::vector<int>& deriving,
                                   std::vector<EntityId> ends) {
  std::vector<bool> found(m.entities.size(), false);
  while (!ends.empty()) {
    const EntityId e = ends.back();
    ends.pop_back();
    if (found[e]) continue;
    found[e] = true;
    if (deriving[e] < 0) continue;
    const std::vector<EntityId>& operands = m.constraints[deriving[e]].operands;
    ends.insert(ends.end(), operands.begin(), operands.end());
  }
  return found;
}

}  // namespace

void keep_derivations(Model& m) {
  const std::vector<bool> independent = independent_coordinates(m);
  std::vector<int> deriving(m.entities.size(), no_position);
  const auto can_derive = [&](const Constraint& c, EntityId id) {
    const Entity& e = m.entities[id];
    if (c.left_out || e.fixed || e.group != c.group || independent[e.first] || deriving[id] >= 0 ||
        !is_explicit(c, e.size))
      return false;
    std::vector<EntityId> others = c.operands;
    std::erase(others, id);
    return !ends_and_sources(m, deriving, others)[id];
  };
  for (int i = 0; i < static_cast<int>(m.constraints.size()); ++i) {
    Constraint& c = m.constraints[i];
    if (c.derives < 0) continue;
    if (const EntityId id = derived_entity(c); can_derive(c, id))
      deriving[id] = i;
    else
      c.derives = no_position;
  }
}

std::vector<Derivation> derivations(const Model& m, const PartDefinition& part) {
  // Each equation counts by itself: Partition::block may put equations of one constraint into
  // several parts.
  std::vector<std::vector<Derivation>> of_entity(m.entities.size());
  const auto constraint_of = [&](const Equation& e) -> const Constraint& {
    return m.constraints[e.constraint];
  };
  for (std::size_t row = 0; row < part.equations.size(); ++row) {
    const EntityId e = derived_entity(constraint_of(part.equations[row]));
    if (e < 0) continue;
    const int column = position_in(part.unknowns, m.entities[e].first + part.equations[row].row);
    if (column >= 0) of_entity[e].push_back({static_cast<int>(row), column});
  }
  std::vector<Derivation> result;
  const auto append = [&](auto&& self, EntityId e) -> void {
    const std::vector<Derivation> own = std::exchange(of_entity[e], {});  // appended once
    if (own.empty()) return;
    for (const EntityId operand : constraint_of(part.equations[own.front().row]).operands)
      self(self, operand);
    result.insert(result.end(), own.begin(), own.end());
  };
  for (const Equation& equation : part.equations)
    if (const EntityId e = derived_entity(constraint_of(equation)); e >= 0) append(append, e);
  return result;
}

std::vector<PartDefinition> split_outputs(const Model& m, const PartDefinition& part) {
  std::vector<int> deriving(m.entities.size(), no_position);  // by constraints of the part
  std::vector<EntityId> of_closures;
  for (const Equation& equation : part.equations) {
    const Constraint& c = m.constraints[equation.constraint];
    if (c.derives < 0)
      of_closures.insert(of_closures.end(), c.operands.begin(), c.operands.end());
    else
      deriving[derived_entity(c)] = equation.constraint;
  }
  const std::vector<bool> needed = ends_and_sources(m, deriving, std::move(of_closures));
  const auto is_output = [&](EntityId e) { return deriving[e] >= 0 && !needed[e]; };

  PartDefinition core{part.groups, {}, {}, part.constant}, outputs = core;
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  for (const int i : part.unknowns) (is_output(owner[i]) ? outputs : core).unknowns.push_back(i);
  for (const Equation& e : part.equations) {
    const EntityId derived = derived_entity(m.constraints[e.constraint]);
    (derived >= 0 && is_output(derived) ? outputs : core).equations.push_back(e);
  }
  std::vector<PartDefinition> result;
  for (PartDefinition* p : {&core, &outputs})
    if (!p->unknowns.empty()) result.push_back(std::move(*p));
  return result;
}

}  // namespace desmo
