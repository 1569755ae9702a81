#pragma once

#include <Eigen/Core>
#include <cmath>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "formulations/algebra/equilibration.h"
#include "formulations/algebra/linear_solver.h"
#include "formulations/base/settings.h"
#include "formulations/equations/equations.h"

namespace desmo {

/// The Jacobian of a part, its factors, and the rule by which they are renewed (JacobianUpdate):
///
/// - newton: in every iteration and, for rates, at the solved position.
/// - step: for rates, at the solved position. The next step iterates with these factors, and
///   converges linearly. A step after one that ended at the level of positions makes factors in its
///   first iteration.
///
/// The rate of old factors is ρ = ‖Φ‖ after a correction / ‖Φ‖ before it. They are replaced where
/// LinearSolver::break_even_solves more corrections at that rate would not meet the tolerance. (The
/// tolerance is a limit of ‖Φ‖, whose components have one unit. The rate of ‖Φ‖ is known one solve
/// earlier than that of the corrections ‖Δφ‖.)
///
/// A step calls, in this order:
/// 1. begin_position()
/// 2. in each iteration give_up() if led_away(), else prepare_correction() and solve()
/// 3. end_at_position() where the step ends at the level of positions, otherwise factor_at(),
///    evaluate_known(), and solve() for each rate
class JacobianFactors {
 public:
  /// - equations: those of the part; outlive this object
  /// - weights: 1/magnitude of each equation; copied
  /// - magnitudes: one for each unknown; empty: all are 1; copied
  /// - tolerance: limit of the weighted ‖Φ‖ below which a position is accepted; infinite: old
  ///   factors are never too slow
  /// - solver: made for the equations' pattern
  JacobianFactors(const Equations& equations, std::span<const double> weights,
                  std::span<const double> magnitudes, double tolerance,
                  std::unique_ptr<LinearSolver> solver)
      : equations_(equations),
        equilibrated_(equations.pattern(), weights, magnitudes),
        solver_(std::move(solver)),
        break_even_solves_(solver_->break_even_solves()),
        tolerance_(tolerance),
        values_(equations.pattern().size(), 0.0) {
    equations_.constant_jacobian(values_.data());
  }

  const LinearSolver& solver() const { return *solver_; }
  /// Returns Φ_φ and Φ_h where they were evaluated last, laid out by the pattern.
  const double* values() const { return values_.data(); }

  /// Begins the iterations of a position.
  void begin_position(JacobianUpdate update) {
    update_ = update;
    last_correction_ = Correction::none;
  }

  /// Returns whether the last correction came from old factors and led away from the solution. Then
  /// ‖Φ‖ is neither below the tolerance nor smaller than before. residual: weighted ‖Φ‖ now.
  bool led_away(double residual) const {
    return corrects_with_old() && !(residual < tolerance_) && !(residual < last_residual_);
  }

  /// Discards the factors that led away.
  void give_up() {
    has_factors_ = false;
    last_correction_ = Correction::none;
  }

  /// Chooses the factors of the next correction: those at hand, or new ones at q. residual:
  /// weighted ‖Φ‖ at q. Returns false where Φ_φ is singular.
  [[gnu::always_inline]] bool prepare_correction(const double* q, double residual) {
    const bool keeps = update_ != JacobianUpdate::newton && has_factors_ &&
                       (last_correction_ == Correction::none || are_fast_enough(residual));
    last_correction_ = keeps ? Correction::by_old_factors : Correction::by_new_factors;
    last_residual_ = residual;
    return keeps || factor_at(q);
  }
  /// Returns whether the correction comes from old factors.
  bool corrects_with_old() const { return last_correction_ == Correction::by_old_factors; }

  /// Ends a step at the level of positions: its factors do not serve the next one.
  void end_at_position() { has_factors_ = false; }

  // Members marked always_inline are called in every iteration of small parts. Without the mark,
  // whether the compiler inlines them depends on the code around.

  /// Evaluates Φ_φ at q and factorises it. Returns false where it is singular.
  [[gnu::always_inline]] bool factor_at(const double* q) {
    equations_.jacobian(q, values_.data());
    has_factors_ = solver_->factor(equilibrated_.matrix(values_.data()));
    return has_factors_;
  }

  /// Evaluates Φ_h at q.
  void evaluate_known(const double* q) { equations_.known_jacobian(q, values_.data()); }

  /// Overwrites b with Φ_φ⁻¹ b by the factors at hand.
  void solve(Eigen::VectorXd& b) { equilibrated_.solve(*solver_, b.data()); }
  /// Like solve(), for b with 0 in the rows of derivations; derived unknowns become 0.
  void solve_closures(Eigen::VectorXd& b) { equilibrated_.solve_closures(*solver_, b.data()); }

  /// Discards the factors and the order of their pivots.
  void forget() {
    has_factors_ = false;
    solver_->forget_pivots();
  }

 private:
  enum class Correction : char {
    none,  // no correction since begin_position() or give_up()
    by_old_factors,
    by_new_factors
  };

  /// Returns whether break_even_solves_ more corrections at the last one's rate would meet the
  /// tolerance.
  bool are_fast_enough(double residual) const {
    return residual * std::pow(residual / last_residual_, break_even_solves_) < tolerance_;
  }

  const Equations& equations_;
  Equilibration equilibrated_;
  std::unique_ptr<LinearSolver> solver_;
  int break_even_solves_;
  JacobianUpdate update_{};
  double tolerance_;
  std::vector<double> values_;
  bool has_factors_ = false;
  Correction last_correction_ = Correction::none;
  double last_residual_ = 0;  // weighted ‖Φ‖ before the last correction
};

}  // namespace desmo
