#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "formulations/base/index_range.h"
#include "formulations/model/constraint_at.h"
#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// q, q̇ and q̈ of a whole model, each followed by the fixed entities, in any scalar.
template <class S>
struct ScalarState {
  std::vector<S> q, qd, qdd;

  explicit ScalarState(int size) : q(size, S(0)), qd(size, S(0)), qdd(size, S(0)) {}
};

/// The n equations of one part as a dense matrix and vectors in any scalar, from the functions of
/// the constraint kinds. φ are the unknowns of the part, h all other coordinates that it reads.
template <class S>
struct PartSystem {
  std::size_t n;
  std::vector<S> jacobian;      ///< Φ_φ (n × n), by rows
  std::vector<S> phi;           ///< Φ
  std::vector<S> velocity;      ///< right-hand side of Φ_φ φ̇ = −Φ_h ḣ
  std::vector<S> acceleration;  ///< right-hand side of Φ_φ φ̈ = −Φ_h ḧ − Φ̇_q q̇

  /// Evaluates the system at a state. `acceleration` also needs the unknowns' velocities in it.
  PartSystem(const Model& m, const PartDefinition& part, const ScalarState<S>& state)
      : n(part.unknowns.size()), jacobian(n * n, S(0)), m_(m), part_(part), state_(state) {
    for (std::vector<S>* v : {&phi, &velocity, &acceleration}) v->assign(n, S(0));
    for (int row = 0; row < static_cast<int>(n);) row = add_constraint(row);
  }

 private:
  /// Adds the equations of one constraint, from `row` on. Returns the row after the last one.
  int add_constraint(int row) {
    const int end = static_cast<int>(part_.equations.size());
    const int position = part_.equations[row].constraint;
    const Constraint& constraint = m_.constraints[position];
    const ConstraintAt<S> at(m_, constraint, state_.q.data());
    std::array<S, max_rows> all_phi, gamma;
    at.residual(all_phi.data());
    at.quadratic(operands_of(m_, constraint, state_.qd.data()), gamma.data());
    std::array<int, max_rows> place;
    place.fill(-1);
    for (; row < end && part_.equations[row].constraint == position; ++row) {
      const int r = part_.equations[row].row;
      place[r] = row;
      phi[row] = all_phi[r];
      acceleration[row] -= gamma[r];
    }
    at.jacobian([&](int r, int operand, int i, const S& value) {
      const int state = m_.state_index(constraint.operands[operand]) + i;
      if (place[r] < 0) return;
      if (const int j = position_in(part_.unknowns, state); j >= 0) {
        jacobian[place[r] * n + j] = value;
      } else {
        velocity[place[r]] -= value * state_.qd[state];
        acceleration[place[r]] -= value * state_.qdd[state];
      }
    });
    return row;
  }

  const Model& m_;
  const PartDefinition& part_;
  const ScalarState<S>& state_;
};

}  // namespace desmo
