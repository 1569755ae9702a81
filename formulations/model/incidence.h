#pragma once

#include "formulations/constraints/kinds.h"
#include "formulations/model/model.h"

namespace desmo {

/// Calls visit(row, state) for each structurally nonzero entry of a constraint's Jacobian.
/// row: row of the constraint. state: index of the variable in the state.
template <class Visit>
void visit_incidence(const Model& m, const Constraint& constraint, Visit&& visit) {
  for (const auto& [row, operand, component] : description_of(constraint.kind).entries)
    visit(row, m.state_index(constraint.operands[operand]) + component);
}

}  // namespace desmo
