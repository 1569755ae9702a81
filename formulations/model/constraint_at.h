#pragma once

#include <array>
#include <cstddef>

#include "cases/numbers/derived.h"
#include "formulations/constraints/coordinates.h"
#include "formulations/constraints/kinds.h"
#include "formulations/model/model.h"

namespace desmo {

/// Returns the constants that the functions of a constraint's kind take at x, from its dimensions
/// as the file means them, in the scalar of x: see constants_at().
template <class S>
std::array<S, max_constants> dimensions_at(const Constraint& constraint, const S* const* x) {
  const KindDescription& kind = description_of(constraint.kind);
  const auto number = [&](int k) { return as<S>(constraint.constants[k]); };
  if (kind.table >= 0) return TableCoupling::about_number(number, x[1][0]);
  std::array<S, max_constants> all{};
  for (int k = 0; k < kind.constants; ++k) all[k] = number(k);
  return all;
}

/// Returns a pointer to the first component of each operand of a constraint; null beyond the last
/// one. state: (Model::state_size()), in any scalar; it must outlive them.
template <class S>
std::array<const S*, max_operands> operands_of(const Model& m, const Constraint& constraint,
                                               const S* state) {
  std::array<const S*, max_operands> result{};
  for (std::size_t k = 0; k < constraint.operands.size(); ++k)
    result[k] = state + m.state_index(constraint.operands[k]);
  return result;
}

/// The functions of one constraint of a model at given operands, in any scalar.
template <class S>
class ConstraintAt {
 public:
  const KindDescription& kind;
  const std::array<const S*, max_operands> x;  ///< first component of each operand

  /// state: (Model::state_size()); it must outlive this object.
  ConstraintAt(const Model& m, const Constraint& constraint, const S* state)
      : ConstraintAt(constraint, operands_of(m, constraint, state)) {}
  ConstraintAt(const Constraint& constraint, const std::array<const S*, max_operands>& operands)
      : kind(description_of(constraint.kind)),
        x(operands),
        number_(constraint.kind),
        constants_(dimensions_at(constraint, x.data())) {}

  /// Overwrites phi (rows).
  void residual(S* phi) const {
    KindFunctions<S>::residual(number_, x.data(), constants_.data(), phi);
  }
  /// Calls visit(row, operand, component, value) for each structurally nonzero entry of Φ_q.
  template <class Visit>
  void jacobian(Visit&& visit) const {
    std::array<S, max_entries> values;
    KindFunctions<S>::jacobian(number_, x.data(), constants_.data(), values.data());
    const S* value = values.data();
    for (const auto& [row, operand, component] : kind.entries)
      visit(row, operand, component, *value++);
  }
  /// Overwrites gamma (rows). v: velocities, pointers as in x.
  void quadratic(const std::array<const S*, max_operands>& v, S* gamma) const {
    KindFunctions<S>::quadratic(number_, x.data(), v.data(), constants_.data(), gamma);
  }

 private:
  int number_;
  std::array<S, max_constants> constants_;
};

}  // namespace desmo
