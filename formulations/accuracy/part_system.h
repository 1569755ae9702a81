#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

#include "cases/mechanism.h"
#include "formulations/partition.h"

namespace desmo {

/// q, q̇ and q̈ of a whole mechanism with its fixed entities behind, in any scalar.
template <class S>
struct WideState {
  std::vector<S> q, qd, qdd;

  explicit WideState(int size) : q(size, S(0)), qd(size, S(0)), qdd(size, S(0)) {}
};

/// The equations of one part as dense matrices, in any scalar, from what each constraint kind
/// states of itself.
template <class S>
struct PartSystem {
  using Vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
  using Matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;

  Matrix jacobian;  ///< Φ_φ
  Vector phi;
  Vector velocity;      ///< −Φ_h ḣ
  Vector acceleration;  ///< −Φ_h ḧ − Φ̇_q q̇

  /// At a state. `acceleration` also needs the velocities of the part's own unknowns in it.
  PartSystem(const Mechanism& m, const PartDefinition& part, const WideState<S>& state)
      : m_(m), part_(part), state_(state) {
    const auto n = static_cast<Eigen::Index>(part.unknowns.size());
    jacobian.setZero(n, n);
    for (Vector* v : {&phi, &velocity, &acceleration}) v->setZero(n);
    for (int row = 0; row < static_cast<int>(n);) row = add_constraint(row);
  }

 private:
  /// The equations of one constraint, the first of which stands in that row. Returns the row after
  /// the last.
  int add_constraint(int row) {
    const int n = static_cast<int>(part_.equations.size());
    const int position = part_.equations[row].constraint;
    const Constraint& constraint = m_.constraints[position];
    visit_kind(constraint.kind, [&]<class Kind>(Kind) {
      std::array<const S*, Kind::operand_sizes.size()> x, v;
      std::array<int, Kind::operand_sizes.size()> first;
      for (std::size_t k = 0; k < first.size(); ++k) {
        first[k] = m_.state_index(constraint.operands[k]);
        x[k] = state_.q.data() + first[k];
        v[k] = state_.qd.data() + first[k];
      }
      std::array<S, Kind::constants + 1> constants{};
      std::ranges::copy(constraint.constants, constants.begin());
      std::array<S, Kind::rows> all_phi, gamma;
      Kind::residual(x.data(), constants.data(), all_phi.data());
      Kind::quadratic(x.data(), v.data(), constants.data(), gamma.data());
      std::array<int, Kind::rows> place;
      place.fill(-1);
      for (; row < n && part_.equations[row].constraint == position; ++row) {
        const int r = part_.equations[row].row;
        place[r] = row;
        phi[row] = all_phi[r];
        acceleration[row] -= gamma[r];
      }
      Kind::jacobian(x.data(), constants.data(), [&](int r, int operand, int i, const S& value) {
        const int at = first[operand] + i;
        if (place[r] < 0) return;
        if (const int j = column(at); j >= 0) {
          jacobian(place[r], j) = value;
        } else {
          velocity[place[r]] -= value * state_.qd[at];
          acceleration[place[r]] -= value * state_.qdd[at];
        }
      });
    });
    return row;
  }

  /// Of a component of the state; -1: the part takes it as known.
  int column(int at) const {
    const auto it = std::ranges::lower_bound(part_.unknowns, at);
    return it != part_.unknowns.end() && *it == at ? static_cast<int>(it - part_.unknowns.begin())
                                                   : -1;
  }

  const Mechanism& m_;
  const PartDefinition& part_;
  const WideState<S>& state_;
};

}  // namespace desmo
