#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "formulations/base/part.h"
#include "formulations/parts/jacobian_factors.h"
#include "formulations/parts/part_unknowns.h"

namespace desmo {

/// Limits within which Newton's iterations find a position.
struct NewtonLimits {
  double tolerance;  ///< on ‖Φ‖
  int min_iterations, max_iterations;
  bool corrects_solved;  ///< one more correction follows where the tolerance is first met

  explicit NewtonLimits(const PartSettings& s)
      : tolerance(s.tolerance),
        min_iterations(s.fixed_iterations),
        max_iterations(s.max_iterations),
        corrects_solved(s.at_rounding) {
    if (min_iterations == 0) return;
    tolerance = std::numeric_limits<double>::infinity();
    max_iterations = min_iterations;
  }

  /// The rule that ends the iterations of one position. It ends them at the first position within
  /// the tolerance, whatever factors led there, but not before min_iterations. Where
  /// `corrects_solved` it asks for one more correction first, unless max_iterations are done.
  class Acceptance {
   public:
    explicit Acceptance(const NewtonLimits& limits)
        : limits_(limits), is_last_(!limits.corrects_solved) {}

    /// Returns whether the iterations end at this position. Notes that the tolerance was met.
    bool update(double residual, int iterations) {
      if (!(residual < limits_.tolerance) || iterations < limits_.min_iterations) return false;
      return std::exchange(is_last_, true) || iterations == limits_.max_iterations;
    }

   private:
    const NewtonLimits& limits_;
    bool is_last_;
  };
};

/// Newton–Raphson on a part's equations (paper, Fig. 2b), for every way of evaluating equations
/// and of solving linear systems. Real is double or float. JacobianFactors decides when Φ_φ is
/// factorised. A correction by old factors is taken back unless it made ‖Φ‖ smaller or met the
/// tolerance; one that led to NaN is taken back, too.
///
/// A step that fails is tried a second time, from the same prediction, where factors or a pivot
/// order may have been old. The second attempt discards both and factorises in every iteration.
template <class Real>
class NewtonSolver {
 public:
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

  /// weights: 1/magnitude of each equation, by which ‖Φ‖₂ does not depend on units. magnitudes: of
  /// the unknowns; empty: all are 1. linear_solver: of the pattern of these equations.
  NewtonSolver(std::unique_ptr<const Equations<Real>> equations, std::span<const double> weights,
               std::span<const double> magnitudes, const PartSettings& settings,
               std::unique_ptr<LinearSolver<Real>> linear_solver)
      : equations_(std::move(equations)),
        pattern_(equations_->pattern()),
        unknowns_(pattern_.unknowns),
        limits_(settings),
        update_(settings.jacobian),
        per_level_(settings.factorisation == Factorisation::per_level),
        reuses_pivots_(linear_solver->reuses_pivots()),
        weights_(
            Eigen::Map<const Eigen::VectorXd>(weights.data(), pattern_.n).template cast<Real>()),
        factors_(*equations_, weights, weights_, magnitudes, update_, limits_.tolerance,
                 std::move(linear_solver)),
        b_(pattern_.n),
        correction_(pattern_.n),
        start_(pattern_.n) {}

  NewtonSolver(const NewtonSolver&) = delete;
  NewtonSolver& operator=(const NewtonSolver&) = delete;

  const Pattern& pattern() const { return pattern_; }

  /// See Part::reuses_pivots.
  bool reuses_pivots() const { return reuses_pivots_; }
  /// See LinearSolver::pivot_shrinkage.
  double pivot_shrinkage() const { return factors_.solver().pivot_shrinkage(); }
  /// See Part::refactorisations.
  long refactorisations() const { return std::max(0L, factors_.solver().pivot_choices() - 1); }

  /// See Part::solve; q, qd and qdd are the state and its time derivatives.
  PartResult solve(Real* q, Real* qd, Real* qdd, Level level) {
    if (!reuses_pivots_ && update_ == JacobianUpdate::newton)
      return attempt(q, qd, qdd, level, update_);
    unknowns_.for_each([&](int at, int i) { start_[i] = q[at]; });
    const PartResult first = attempt(q, qd, qdd, level, update_);
    if (first.status == Status::solved) return first;
    // Perhaps only the factors, or their pivots, had gone bad.
    unknowns_.for_each([&](int at, int i) { q[at] = start_[i]; });
    factors_.forget();
    PartResult second = attempt(q, qd, qdd, level, JacobianUpdate::newton);
    second.iterations += first.iterations;
    return second;
  }

 private:
  PartResult attempt(Real* q, Real* qd, Real* qdd, Level level, JacobianUpdate update) {
    factors_.begin_position(update);
    PartResult result = position(q);
    if (result.status != Status::solved) return result;
    if (level == Level::position)
      factors_.end_at_position();
    else if (!rates(q, qd, qdd, level))
      result.status = Status::singular;
    return result;
  }

  // ---- The paper's Fig. 2b ----

  PartResult position(Real* q) {
    PartResult result;
    NewtonLimits::Acceptance acceptance(limits_);
    for (;; ++result.iterations) {
      equations_->residual(q, b_.data());  // Φ
      const double residual = weights_.cwiseProduct(b_).norm();
      result.residual2 = residual * residual;
      if (acceptance.update(residual, result.iterations)) return result;
      const bool is_over = result.iterations == limits_.max_iterations;
      if (!is_over && factors_.led_away(residual)) {
        retract(q);
        continue;
      }
      if (is_over || !std::isfinite(residual))
        return failure(result,
                       std::isfinite(residual) ? Status::not_converged : Status::not_finite);
      if (!factors_.prepare_correction(q, residual)) return failure(result, Status::singular);
      factors_.solve(b_);                                          // Φ_φ Δφ = Φ
      unknowns_.for_each([&](int at, int i) { q[at] -= b_[i]; });  // eq. (2)
      if (factors_.corrects_with_old()) b_.swap(correction_);      // kept for retract()
    }
  }

  bool rates(const Real* q, Real* qd, Real* qdd, Level level) {
    if (!factors_.prepare_rates(q)) return false;
    factors_.evaluate_known(q);
    if (!velocity(qd)) return false;
    if (level == Level::velocity) return true;
    // Where each level makes factors of its own (Factorisation::per_level).
    if (per_level_ && !factors_.factor_at(q)) return false;
    return acceleration(q, qd, qdd);
  }

  bool velocity(Real* qd) {
    b_.setZero();
    subtract_known_product(qd);                   // −Φ_h ḣ
    if (!factors_.solve_rates(b_)) return false;  // eq. (3)
    scatter(qd);
    return true;
  }

  bool acceleration(const Real* q, const Real* qd, Real* qdd) {
    equations_->quadratic(q, qd, b_.data());
    b_ = -b_;                                     // −Φ̇_q q̇
    subtract_known_product(qdd);                  // −Φ_h ḧ
    if (!factors_.solve_rates(b_)) return false;  // eq. (4)
    scatter(qdd);
    return true;
  }

  static PartResult failure(PartResult result, Status status) {
    result.status = status;
    return result;
  }

  /// Takes back a correction that old factors gave, and gives these up.
  void retract(Real* q) {
    unknowns_.for_each([&](int at, int i) { q[at] += correction_[i]; });
    factors_.give_up();
  }

  void subtract_known_product(const Real* rate) {
    const Real* value = factors_.values() + pattern_.dependent_entries();
    for (const JacobianEntry& e : pattern_.known) b_[e.row] -= *value++ * rate[e.place];
  }

  [[gnu::always_inline]] void scatter(Real* target) const {
    unknowns_.for_each([&](int at, int i) { target[at] = b_[i]; });
  }

  std::unique_ptr<const Equations<Real>> equations_;
  const Pattern& pattern_;
  PartUnknowns unknowns_;
  NewtonLimits limits_;
  JacobianUpdate update_;
  bool per_level_, reuses_pivots_;  // the latter: see LinearSolver
  Vector weights_;
  JacobianFactors<Real> factors_;
  Vector b_;           // right-hand side, then solution
  Vector correction_;  // the last one by old factors
  Vector start_;       // unknowns at the start of the step
};

}  // namespace desmo
