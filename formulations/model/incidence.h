#pragma once

#include <array>
#include <cstddef>

#include "cases/numbers/derived.h"
#include "formulations/constraints/constraints.h"
#include "formulations/model/model.h"

namespace desmo {

/// Returns the constants that the functions of a kind take at x, from the dimensions of a
/// constraint as the file means them, in the scalar of x: see constants_at(). The result has
/// data().
template <class Kind, class S>
auto dimensions_at(const Constraint& constraint, const S* const* x) {
  const auto number = [&](int k) { return as<S>(constraint.constants[k]); };
  if constexpr (has_table<Kind>) {
    return Kind::about_number(number, x[1][0]);
  } else {
    std::array<S, Kind::constants + 1> all{};
    for (int k = 0; k < Kind::constants; ++k) all[k] = number(k);
    return all;
  }
}

/// Calls visit(row, operand, component, value) for each structurally nonzero entry of a
/// constraint's Jacobian. value: the entry where all coordinates are 1.
template <class Visit>
void visit_entries(const Constraint& constraint, Visit&& visit) {
  visit_kind(constraint.kind, [&]<class Kind>(Kind) {
    // The structure does not depend on the values: any values serve.
    static constexpr std::array<double, max_components> any{1, 1, 1, 1};
    std::array<const double*, Kind::operand_sizes.size()> x;
    x.fill(any.data());
    Kind::jacobian(x.data(), dimensions_at<Kind>(constraint, x.data()).data(), visit);
  });
}

/// Calls visit(row, state) for each structurally nonzero entry of a constraint's Jacobian.
/// row: row of the constraint. state: index of the variable in the state.
template <class Visit>
void visit_incidence(const Model& m, const Constraint& constraint, Visit&& visit) {
  visit_entries(constraint, [&](int row, int operand, int component, double) {
    visit(row, m.state_index(constraint.operands[operand]) + component);
  });
}

/// Returns an array of pointers to the first component of each operand of a constraint.
/// state: (Model::state_size()), in any scalar; it must outlive them.
template <class Kind, class S>
auto operands_of(const Model& m, const Constraint& constraint, const S* state) {
  std::array<const S*, Kind::operand_sizes.size()> x;
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = state + m.state_index(constraint.operands[k]);
  return x;
}

}  // namespace desmo
