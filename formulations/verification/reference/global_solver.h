#pragma once

#include <span>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/motion/groupwise/reference_solver.h"
#include "formulations/verification/reference/scaled_factors.h"

namespace desmo {

/// Solver of all equations of a model at once, in the scalar S (Quadruple, or double for positions
/// alone). The residuals alone determine the result: jets evaluate Φ, Φ̇ and Φ̈ in S, and the rates
/// make Φ̇ and Φ̈ vanish. Sparse LU factors in double precision only steer the iteration: each
/// correction multiplies the error by about κ u, with the condition number κ and u = 2⁻⁵³. The
/// partition and the quadratic terms are not used.
template <class S>
class GlobalSolver : public ReferenceSolver<S> {
 public:
  /// Starts at the model's initial estimate. The model must outlive the solver.
  explicit GlobalSolver(const Model& model) : ReferenceSolver<S>(model), factors_(model) {}

  /// Makes correct_positions() solve Φ = share × Φ₀, where Φ₀ is Φ at the first set_homotopy().
  void set_homotopy(double share);
  /// Makes one correction by Newton's method. Returns its largest component relative to the nominal
  /// magnitude of the coordinate. Throws std::runtime_error when the matrix is singular.
  double correct_positions();

  /// Solves the positions at time t [s] as accurately as S allows, starting from the present ones.
  /// Throws std::runtime_error, naming the instant, when Newton's method does not converge or a
  /// matrix is singular.
  void solve_positions(double t);

  /// Solves velocities, then accelerations, at the positions solved last. Both are linear problems;
  /// corrections refine them until only rounding is left.
  void solve_rates();

 private:
  using ReferenceSolver<S>::m_;
  using ReferenceSolver<S>::state_;

  void factor();
  double correct(std::span<const S> residual, std::vector<S>& values);
  const WholeSystem& system() const { return factors_.system(); }

  ScaledFactors factors_;   // of Φ_φ at the present positions
  std::vector<S> initial_;  // Φ₀; empty: no homotopy
  double share_ = 0;        // factor of Φ₀
  double time_ = 0;         // present time [s], for messages
};

}  // namespace desmo
