#pragma once

#include <array>

#include "formulations/constraints/constraints.h"
#include "formulations/model/model.h"

namespace desmo {

/// Calls visit(row, state) for each structurally nonzero entry of a constraint's Jacobian.
/// row: row of the constraint. state: index of the variable in the state.
template <class Visit>
void visit_incidence(const Model& m, const Constraint& constraint, Visit&& visit) {
  visit_kind(constraint.kind, [&]<class Kind>(Kind) {
    // The structure does not depend on the values: any values serve.
    static constexpr std::array<double, max_components> any{1, 1, 1, 1};
    std::array<const double*, Kind::operand_sizes.size()> x;
    x.fill(any.data());
    Kind::jacobian(x.data(), constants_at<Kind>(constraint.constants.data(), x.data()).data(),
                   [&](int row, int operand, int component, double) {
                     visit(row, m.state_index(constraint.operands[operand]) + component);
                   });
  });
}

}  // namespace desmo
