#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "formulations/algebra/equilibration.h"
#include "formulations/algebra/iterative_refinement.h"
#include "formulations/algebra/linear_solver.h"
#include "formulations/base/settings.h"
#include "formulations/equations/equations.h"

namespace desmo {

/// The Jacobian of a part, its factors, and the decision when they are made anew (JacobianUpdate):
///
/// - newton: in every iteration, and at the solved position.
/// - step: at the solved position. The next step iterates with them, and converges linearly. Steps
///   that end at the level of positions make them in their first iteration.
/// - chord: where the factors at hand have become too slow. Velocity and acceleration are solved
///   with old factors, refined with the Jacobian of the solved position (IterativeRefinement) until
///   they are as accurate. Where that would take more sweeps than new factors cost, it is
///   factorised.
///
/// Old factors are watched by the rate ρ = ‖Φ‖ / ‖Φ‖ before. They are replaced where
/// LinearSolver::break_even_solves more corrections at that rate would not meet the tolerance.
/// (‖Φ‖ is what is compared with the tolerance, it has one unit, and its rate is known one solve
/// earlier than that of ‖Δφ‖.)
///
/// A step calls, in this order:
/// 1. begin_position()
/// 2. in each iteration give_up() if led_away(), else prepare_correction() and solve()
/// 3. end_at_position() where the step ends at the level of positions, otherwise
///    prepare_rates(), evaluate_known(), and solve_rates() for velocity
/// 4. solve_rates() for acceleration, after factor_at() where each level makes factors of its own
template <class Real>
class JacobianFactors {
 public:
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

  /// - equations: of the part; outlive this object
  /// - weights: 1/magnitude of each equation; copied
  /// - rounded_weights: the same as Real; outlive this object
  /// - magnitudes: of the unknowns; empty: all are 1; copied
  /// - tolerance: limit of ‖Φ‖ below which a position is accepted; infinite: old factors never are
  ///   too slow
  /// - solver: of the equations' pattern
  JacobianFactors(const Equations<Real>& equations, std::span<const double> weights,
                  const Vector& rounded_weights, std::span<const double> magnitudes,
                  JacobianUpdate update, double tolerance,
                  std::unique_ptr<LinearSolver<Real>> solver)
      : equations_(equations),
        equilibrated_(equations.pattern(), weights, magnitudes),
        solver_(std::move(solver)),
        break_even_solves_(solver_->break_even_solves()),
        has_rounded_factors_(solver_->rounds_factors()),
        requested_update_(update),
        tolerance_(tolerance),
        values_(equations.pattern().size(), Real(0)),
        refinement_(rounded_weights, refines()) {
    equations_.constant_jacobian(values_.data());
  }

  const LinearSolver<Real>& solver() const { return *solver_; }
  /// Returns Φ_φ and Φ_h where they were evaluated last, laid out by the pattern.
  const Real* values() const { return values_.data(); }

  /// Begins the iterations of a position.
  void begin_position(JacobianUpdate update) {
    active_update_ = update;
    last_correction_ = Correction::none;
  }

  /// Returns whether the last correction came from old factors and led away from the solution.
  bool led_away(double residual) const {
    return corrects_with_old() && !(residual < tolerance_) && !(residual < last_residual_);
  }

  /// Gives the factors up that led away.
  void give_up() {
    factors_ = Factors::none;
    last_correction_ = Correction::none;
  }

  /// Chooses the factors of the next correction: those at hand, or new ones at q. Returns false
  /// where Φ_φ is singular.
  [[gnu::always_inline]] bool prepare_correction(const Real* q, double residual) {
    const bool keeps = active_update_ != JacobianUpdate::newton && factors_ != Factors::none &&
                       (last_correction_ == Correction::none || are_fast_enough(residual));
    last_correction_ = keeps ? Correction::by_old_factors : Correction::by_new_factors;
    last_residual_ = residual;
    return keeps || factor_at(q);
  }
  /// Returns whether the correction comes from old factors.
  bool corrects_with_old() const { return last_correction_ == Correction::by_old_factors; }

  /// Ends a step at the level of positions: factors of JacobianUpdate::step serve one step.
  void end_at_position() {
    if (active_update_ == JacobianUpdate::step) factors_ = Factors::none;
  }

  /// Prepares solve_rates() at the solved position. Returns false where Φ_φ is singular.
  bool prepare_rates(const Real* q) {
    if (active_update_ != JacobianUpdate::chord || factors_ == Factors::none) return factor_at(q);
    equations_.jacobian(q, values_.data());
    factors_ = Factors::of_earlier_values;
    return true;
  }

  // Members marked always_inline are called in every iteration of small parts. The compiler would
  // decide otherwise as soon as the surroundings change.

  /// Evaluates Φ_φ at q and factorises it. Returns false where it is singular.
  [[gnu::always_inline]] bool factor_at(const Real* q) {
    equations_.jacobian(q, values_.data());
    return factor();
  }

  /// Evaluates Φ_h at q.
  void evaluate_known(const Real* q) { equations_.known_jacobian(q, values_.data()); }

  /// Overwrites b with Φ_φ⁻¹ b by the factors at hand.
  void solve(Vector& b) { equilibrated_.solve(*solver_, b.data()); }

  /// Overwrites b with Φ_φ⁻¹ b for Φ_φ as evaluated last, whatever was factorised. Returns false
  /// where it is singular.
  bool solve_rates(Vector& b) {
    const bool are_old = factors_ == Factors::of_earlier_values;
    if (refines() && (has_rounded_factors_ || are_old)) {
      if (solve_refined(b)) return true;
      if (!are_old || !factor()) return false;
      if (has_rounded_factors_) return solve_refined(b);
    }
    solve(b);
    return true;
  }

  /// Discards the factors and the order of their pivots.
  void forget() {
    factors_ = Factors::none;
    solver_->forget_pivots();
  }

 private:
  enum class Factors : char { none, of_values, of_earlier_values };  // of_values: of values_
  enum class Correction : char {
    none,
    by_old_factors,
    by_new_factors
  };  // none: at no position yet

  bool refines() const {
    return has_rounded_factors_ || requested_update_ == JacobianUpdate::chord;
  }

  /// Returns whether corrections as slow as the last one still meet the tolerance in good time.
  bool are_fast_enough(double residual) const {
    return residual * std::pow(residual / last_residual_, break_even_solves_) < tolerance_;
  }

  [[gnu::always_inline]] bool factor() {
    const bool is_regular = solver_->factor(equilibrated_.matrix(values_.data()));
    factors_ = is_regular ? Factors::of_values : Factors::none;
    return is_regular;
  }

  bool solve_refined(Vector& b) {
    return refinement_.solve(
        equations_.pattern(), values_.data(), [this](Real* x) { equilibrated_.solve(*solver_, x); },
        break_even_solves_, b);
  }

  const Equations<Real>& equations_;
  Equilibration<Real> equilibrated_;
  std::unique_ptr<LinearSolver<Real>> solver_;
  int break_even_solves_;
  bool has_rounded_factors_;  // see LinearSolver::rounds_factors
  JacobianUpdate requested_update_, active_update_{};
  double tolerance_;
  std::vector<Real> values_;
  Factors factors_ = Factors::none;
  Correction last_correction_ = Correction::none;
  double last_residual_ = 0;  // ‖Φ‖ an iteration ago
  IterativeRefinement<Real> refinement_;
};

}  // namespace desmo
