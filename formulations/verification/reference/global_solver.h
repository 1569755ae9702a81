#pragma once

#include <memory>
#include <span>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/constraints/jet.h"
#include "formulations/model/model.h"
#include "formulations/verification/reference/whole_system.h"

namespace desmo {

/// Solves all equations of a model at once with a sparse LU factorisation, in the scalar S
/// (Quadruple, or double for positions alone). The residuals alone determine the result: jets
/// evaluate Φ, Φ̇ and Φ̈, and the rates make Φ̇ and Φ̈ vanish. The constraint kinds' Jacobians only
/// steer the iteration. The partition and the quadratic terms are not used.
template <class S>
class GlobalSolver {
 public:
  /// Starts at the model's initial estimate. The model must outlive the solver.
  explicit GlobalSolver(const Model& model);
  ~GlobalSolver();

  /// Sets the start of the next Newton iteration to the positions of another solver.
  template <class T>
  void start_at(const GlobalSolver<T>& other) {
    for (int i = 0; i < m_.coordinates(); ++i) state_[i].value = S(other.state()[i].value);
  }

  /// Sets the positions of all coordinates.
  void place(const std::vector<S>& q) {
    for (int i = 0; i < m_.coordinates(); ++i) state_[i].value = q[i];
  }
  /// Sets the drivers, in the model's order, and nothing else.
  void drive(std::span<const MotionSample<S>> drivers);
  /// Likewise their positions alone.
  void drive(std::span<const S> drivers);
  /// Makes correct_positions() solve Φ = share × Φ₀. Φ₀: Φ at the first set_homotopy().
  void set_homotopy(double share);
  /// Moves the unknowns along their Taylor polynomials of second degree.
  void predict(const S& step);
  /// Makes one correction by Newton's method. Returns its largest component relative to the natural
  /// magnitude. Throws std::runtime_error when the matrix is singular.
  double correct_positions();
  /// Returns to a state() of before.
  void restore(const std::vector<Jet<S>>& state) { state_ = state; }

  /// Solves the positions at time t [s] as accurately as S allows, from the present ones. Throws
  /// std::runtime_error, naming the instant, when Newton's method does not converge or a matrix is
  /// singular.
  void solve_positions(double t);

  /// Solves velocities and accelerations at the positions solved last. Both are linear problems:
  /// the first pass finds q̇, the second q̈, and each later pass refines.
  void solve_rates();

  /// Return the instant solved last, in coordinate order.
  std::vector<S> q() const { return coordinates(&Jet<S>::value); }
  std::vector<S> qd() const { return coordinates(&Jet<S>::first); }
  std::vector<S> qdd() const { return coordinates(&Jet<S>::second); }
  const std::vector<Jet<S>>& state() const { return state_; }

 private:
  struct Linear;  // Φ_φ and its factors

  void factor();
  double correct(S Jet<S>::*order);

  std::vector<S> coordinates(S Jet<S>::*order) const {
    std::vector<S> values;
    for (int i = 0; i < m_.coordinates(); ++i) values.push_back(state_[i].*order);
    return values;
  }

  const Model& m_;
  WholeSystem system_;
  std::vector<double> magnitude_;  // magnitude of each coordinate
  std::vector<Jet<S>> state_;
  std::vector<S> positions_;
  std::vector<Jet<S>> phi_;
  std::vector<S> initial_;  // Φ₀; empty: none
  double share_ = 0;        // of Φ₀
  std::unique_ptr<Linear> linear_;
  double time_ = 0;  // present time [s], for messages
};

}  // namespace desmo
