#pragma once

#include <memory>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/parts/groupwise/reference_solver.h"
#include "formulations/verification/reference/whole_system.h"

namespace desmo {

/// Solves all equations of a model at once with a sparse LU factorisation, in the scalar S
/// (Quadruple, or double for positions alone). The residuals alone determine the result: jets
/// evaluate Φ, Φ̇ and Φ̈, and the rates make Φ̇ and Φ̈ vanish. The constraint kinds' Jacobians only
/// steer the iteration. The partition and the quadratic terms are not used.
template <class S>
class GlobalSolver : public ReferenceSolver<S> {
 public:
  /// Starts at the model's initial estimate. The model must outlive the solver.
  explicit GlobalSolver(const Model& model);
  ~GlobalSolver();

  /// Makes correct_positions() solve Φ = share × Φ₀. Φ₀: Φ at the first set_homotopy().
  void set_homotopy(double share);
  /// Makes one correction by Newton's method. Returns its largest component relative to the natural
  /// magnitude. Throws std::runtime_error when the matrix is singular.
  double correct_positions();

  /// Solves the positions at time t [s] as accurately as S allows, from the present ones. Throws
  /// std::runtime_error, naming the instant, when Newton's method does not converge or a matrix is
  /// singular.
  void solve_positions(double t);

  /// Solves velocities and accelerations at the positions solved last. Both are linear problems:
  /// the first pass finds q̇, the second q̈, and each later pass refines.
  void solve_rates();

 private:
  using ReferenceSolver<S>::m_;
  using ReferenceSolver<S>::state_;
  struct Linear;  // Φ_φ and its factors

  void factor();
  double correct(std::vector<S>& values);

  WholeSystem system_;
  std::vector<S> initial_;  // Φ₀; empty: none
  double share_ = 0;        // of Φ₀
  std::unique_ptr<Linear> linear_;
  double time_ = 0;  // present time [s], for messages
};

}  // namespace desmo
