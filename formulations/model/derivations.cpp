#include "formulations/model/derivations.h"

#include <cmath>

#include "formulations/base/index_range.h"
#include "formulations/model/incidence.h"

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

/// The graph of derivations: the constraint that derives each entity, and its inputs.
class DerivationGraph {
 public:
  explicit DerivationGraph(const Model& m) : m_(m), by_(m.entities.size(), no_position) {}

  int deriving(EntityId e) const { return by_[e]; }
  void add(int constraint) { by_[derived_entity(m_.constraints[constraint])] = constraint; }

  /// Returns whether a derivation would derive its entity from itself.
  bool is_circle(int constraint) const {
    const EntityId entity = derived_entity(m_.constraints[constraint]);
    std::vector<int> waiting{constraint};
    std::vector<bool> seen(m_.entities.size(), false);
    while (!waiting.empty()) {
      const Constraint& c = m_.constraints[waiting.back()];
      waiting.pop_back();
      for (int k = 0; k < static_cast<int>(c.operands.size()); ++k) {
        const EntityId e = c.operands[k];
        if (k == c.derives || seen[e]) continue;
        if (e == entity) return true;
        seen[e] = true;
        if (by_[e] >= 0) waiting.push_back(by_[e]);
      }
    }
    return false;
  }

 private:
  const Model& m_;
  std::vector<int> by_;  // constraint that derives each entity; no_position: none
};

}  // namespace

void keep_derivations(Model& m) {
  const std::vector<bool> independent = independent_coordinates(m);
  DerivationGraph graph(m);
  for (int i = 0; i < static_cast<int>(m.constraints.size()); ++i) {
    Constraint& c = m.constraints[i];
    if (c.derives < 0) continue;
    const EntityId id = derived_entity(c);
    const Entity& e = m.entities[id];
    if (c.left_out || e.fixed || e.group != c.group || independent[e.first] ||
        graph.deriving(id) >= 0 || !is_explicit(c, e.size) || graph.is_circle(i))
      c.derives = no_position;
    else
      graph.add(i);
  }
}

std::vector<Derivation> derivations(const Model& m, const PartDefinition& part) {
  // Each equation counts by itself: Partition::block may put equations of one constraint into
  // several parts.
  std::vector<std::vector<Derivation>> of_entity(m.entities.size());
  std::vector<int> by(m.entities.size(), no_position);
  std::vector<EntityId> order;
  for (std::size_t row = 0; row < part.equations.size(); ++row) {
    const auto [constraint, component] = part.equations[row];
    const EntityId e = derived_entity(m.constraints[constraint]);
    if (e < 0) continue;
    const int column = position_in(part.unknowns, m.entities[e].first + component);
    if (column < 0) continue;
    of_entity[e].push_back({static_cast<int>(row), column});
    if (by[e] < 0) order.push_back(e);
    by[e] = constraint;
  }
  std::vector<Derivation> result;
  std::vector<bool> done(m.entities.size(), false);
  const auto append = [&](auto&& self, EntityId e) -> void {
    if (by[e] < 0 || done[e]) return;
    done[e] = true;
    for (const EntityId operand : m.constraints[by[e]].operands) self(self, operand);
    result.insert(result.end(), of_entity[e].begin(), of_entity[e].end());
  };
  for (const EntityId e : order) append(append, e);
  return result;
}

std::vector<PartDefinition> split_outputs(const Model& m, const PartDefinition& part) {
  // constraint of the part that derives each entity
  std::vector<int> by(m.entities.size(), no_position);
  std::vector<EntityId> waiting;
  for (const Equation& equation : part.equations) {
    const Constraint& c = m.constraints[equation.constraint];
    if (c.derives < 0)
      waiting.insert(waiting.end(), c.operands.begin(), c.operands.end());
    else
      by[derived_entity(c)] = equation.constraint;
  }
  std::vector<bool> needed(m.entities.size(), false);
  while (!waiting.empty()) {
    const EntityId e = waiting.back();
    waiting.pop_back();
    if (needed[e]) continue;
    needed[e] = true;
    if (by[e] >= 0)
      waiting.insert(waiting.end(), m.constraints[by[e]].operands.begin(),
                     m.constraints[by[e]].operands.end());
  }

  PartDefinition core{part.groups, {}, {}, part.constant}, outputs = core;
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  const auto is_output = [&](EntityId e) { return by[e] >= 0 && !needed[e]; };
  for (const int i : part.unknowns) (is_output(owner[i]) ? outputs : core).unknowns.push_back(i);
  for (const Equation& e : part.equations) {
    const Constraint& c = m.constraints[e.constraint];
    (c.derives >= 0 && is_output(derived_entity(c)) ? outputs : core).equations.push_back(e);
  }
  std::vector<PartDefinition> result;
  for (PartDefinition* p : {&core, &outputs})
    if (!p->unknowns.empty()) result.push_back(std::move(*p));
  return result;
}

}  // namespace desmo
