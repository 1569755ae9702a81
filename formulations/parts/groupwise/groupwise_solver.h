#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/model/part_system.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Solves a model group by group with dense matrices and pivoting, in the scalar S, by the paper's
/// equations. Newton's method (eq. 2) finds positions. Velocities (eq. 3) and accelerations (eq. 4)
/// use the partial derivatives and quadratic terms of the constraint kinds. S is double or, with
/// the library desmo_reference, Quadruple.
template <class S>
class GroupwiseSolver {
 public:
  /// Starts at the model's initial estimate. The model must outlive the solver.
  explicit GroupwiseSolver(const Model& model);

  /// Sets the start of the next Newton iteration to the positions of another solver.
  template <class T>
  void start_at(const GroupwiseSolver<T>& other) {
    for (int i = 0; i < m_.coordinates(); ++i) state_.q[i] = other.state().q[i];
  }

  /// Sets all coordinates.
  void place(const std::vector<S>& q) { std::ranges::copy(q, state_.q.begin()); }
  /// Sets the positions of the drivers, in the model's order, and nothing else.
  void drive(std::span<const S> drivers);
  /// Solves Φ = share × Φ₀ from now on. Φ₀: Φ at the first call.
  void set_homotopy(double share);
  /// Makes one correction by Newton's method, group after group. Returns its largest component
  /// relative to the nominal magnitude.
  double correct_positions();

  /// Solves the positions at time t [s] as accurately as S allows, from the present ones. Throws
  /// std::runtime_error, naming the group and the instant, when Newton's method does not converge.
  void solve_positions(double t);

  /// Solves velocities and accelerations at the positions solved last.
  void solve_rates();

  /// Return the instant solved last, in coordinate order.
  std::vector<S> q() const { return coordinates(state_.q); }
  std::vector<S> qd() const { return coordinates(state_.qd); }
  std::vector<S> qdd() const { return coordinates(state_.qdd); }
  const ScalarState<S>& state() const { return state_; }

 private:
  void solve_positions(std::size_t part, double t);
  double correct(std::size_t part);

  std::vector<S> coordinates(const std::vector<S>& values) const {
    return {values.begin(), values.begin() + m_.coordinates()};
  }

  const Model& m_;
  std::vector<PartDefinition> parts_;
  std::vector<double> magnitude_;        // by coordinate
  std::vector<std::vector<S>> initial_;  // Φ₀ of each part; empty: none
  double share_ = 0;                     // of Φ₀
  ScalarState<S> state_;
};

}  // namespace desmo
