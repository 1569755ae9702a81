#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "formulations/algebra/equilibration.h"
#include "formulations/algebra/linear_solver.h"
#include "formulations/algebra/refinement.h"
#include "formulations/base/index_range.h"
#include "formulations/base/part.h"
#include "formulations/equations/equations.h"

namespace desmo {

/// Newton–Raphson on a part's equations (paper, Fig. 2b), for every way of evaluating equations
/// and of solving linear systems. Real is double or float.
///
/// With JacobianUpdate::step and ::chord, iterations use factors that are there already, and
/// converge linearly. Their monitor watches the rate ρ = ‖Φ‖ / ‖Φ‖ before: where
/// LinearSolver::break_even_solves more corrections at that rate would not meet the tolerance the
/// Jacobian is factorised anew at the position reached, and a correction that made ‖Φ‖ larger is
/// taken back first. (‖Φ‖ is what is compared with the tolerance, it has one unit, and its rate is
/// known one solve earlier than that of ‖Δφ‖.) Positions are accepted by the tolerance alone,
/// whatever the factors.
///
/// ::step factorises at the solved position. ::chord solves velocity and acceleration with the old
/// factors, refined with the Jacobian of the solved position (Refinement) until they are as
/// accurate, and factorises it where that would take more sweeps than the factors are worth. At
/// the level of positions ::step makes its factors in the first iteration.
template <class Real>
class NewtonSolver {
 public:
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

  /// weights: 1/magnitude of each equation, by which ‖Φ‖₂ does not depend on units; magnitudes: of
  /// the unknowns, none: all are 1; settings: with the tolerance on that norm of the part's own
  /// equations; linear_solver: of the pattern of these equations.
  NewtonSolver(std::unique_ptr<const Equations<Real>> equations, std::span<const double> weights,
               std::span<const double> magnitudes, const PartSettings& settings,
               std::unique_ptr<LinearSolver<Real>> linear_solver)
      : equations_(std::move(equations)),
        pattern_(equations_->pattern()),
        equilibrated_(pattern_, weights, magnitudes),
        linear_solver_(std::move(linear_solver)),
        break_even_solves_(linear_solver_->break_even_solves()),
        rounds_factors_(linear_solver_->rounds_factors()),
        reuses_pivots_(linear_solver_->reuses_pivots()),
        update_(settings.jacobian),
        per_level_(settings.factorisation == Factorisation::per_level),
        tolerance_(settings.fixed_iterations ? std::numeric_limits<double>::infinity()
                                             : settings.tolerance),
        min_iterations_(settings.fixed_iterations),
        max_iterations_(settings.fixed_iterations ? settings.fixed_iterations
                                                  : settings.max_iterations),
        at_rounding_(settings.at_rounding),
        ranges_(long_ranges(pattern_.unknowns)),
        values_(pattern_.size(), Real(0)),
        weights_(
            Eigen::Map<const Eigen::VectorXd>(weights.data(), pattern_.n).template cast<Real>()),
        b_(pattern_.n),
        correction_(pattern_.n),
        start_(pattern_.n),
        refinement_(weights_, refines()) {
    equations_->constant_jacobian(values_.data());
  }

  NewtonSolver(const NewtonSolver&) = delete;
  NewtonSolver& operator=(const NewtonSolver&) = delete;

  const Pattern& pattern() const { return pattern_; }

  /// See Part::reuses_pivots.
  bool reuses_pivots() const { return reuses_pivots_; }
  /// See LinearSolver::pivot_shrinkage.
  double pivot_shrinkage() const { return linear_solver_->pivot_shrinkage(); }
  /// See Part::refactorisations.
  long refactorisations() const { return std::max(0L, linear_solver_->pivot_choices() - 1); }

  /// See Part::solve; q, qd and qdd are the state and its time derivatives.
  PartResult solve(Real* q, Real* qd, Real* qdd, Level level) {
    if (!reuses_pivots_ && update_ == JacobianUpdate::newton)
      return attempt(q, qd, qdd, level, update_);
    remember_start(q);
    const PartResult result = attempt(q, qd, qdd, level, update_);
    if (result.status == Status::solved) return result;
    restore_start(q);  // perhaps only the factors, or their pivots, had gone bad
    has_factors_ = false;
    linear_solver_->forget_pivots();
    return attempt(q, qd, qdd, level, JacobianUpdate::newton);
  }

 private:
  /// Returns the ranges of the unknowns in the state, whose loops fit wide registers; none where
  /// most are short, so that loops over ranges would cost more.
  static std::vector<IndexRange> long_ranges(std::span<const int> unknowns) {
    constexpr std::size_t min_mean = 8;
    std::vector<IndexRange> ranges = ranges_of(unknowns);
    if (ranges.size() * min_mean > unknowns.size()) ranges.clear();
    return ranges;
  }

  bool refines() const { return rounds_factors_ || update_ == JacobianUpdate::chord; }

  PartResult attempt(Real* q, Real* qd, Real* qdd, Level level, JacobianUpdate update) {
    PartResult result = position(q, update);
    if (result.status != Status::solved) return result;
    if (level == Level::position) {
      if (update == JacobianUpdate::step) has_factors_ = false;  // they serve one step
      return result;
    }
    if (!rates(q, qd, qdd, level, update)) result.status = Status::singular;
    return result;
  }

  PartResult position(Real* q, JacobianUpdate update) {
    PartResult result;
    double before = 0;             // ‖Φ‖ an iteration ago
    bool by_old_factors = false;   // the last correction came from old factors
    bool is_last = !at_rounding_;  // no correction follows where the tolerance is met
    for (;; ++result.iterations) {
      equations_->residual(q, b_.data());  // Φ
      const double residual = weights_.cwiseProduct(b_).norm();
      result.residual2 = residual * residual;
      const bool solved = residual < tolerance_;
      const bool is_over = result.iterations == max_iterations_;
      if (solved && result.iterations >= min_iterations_) {
        if (is_last || is_over) return result;
        is_last = true;
      }
      const bool is_worse = by_old_factors && !solved && !(residual < before);
      if (is_over || (!is_worse && !std::isfinite(residual))) {
        result.status = std::isfinite(residual) ? Status::not_converged : Status::not_finite;
        return result;
      }
      if (is_worse) {
        retract(q);
        by_old_factors = false;
        continue;
      }
      by_old_factors = update != JacobianUpdate::newton && has_factors_ &&
                       (result.iterations == 0 || fast_enough(residual, before));
      if (!by_old_factors && !factor_at(q)) {
        result.status = Status::singular;
        return result;
      }
      equilibrated_.solve(*linear_solver_, b_.data());       // Φ_φ Δφ = Φ
      each_unknown([&](int at, int i) { q[at] -= b_[i]; });  // eq. (2)
      if (by_old_factors) b_.swap(correction_);
      before = residual;
    }
  }

  /// Takes back a correction that old factors gave, and gives these up.
  void retract(Real* q) {
    each_unknown([&](int at, int i) { q[at] += correction_[i]; });
    has_factors_ = false;
  }

  /// Returns whether corrections as slow as the last one still meet the tolerance in good time.
  bool fast_enough(double residual, double before) const {
    return residual * std::pow(residual / before, break_even_solves_) < tolerance_;
  }

  bool rates(const Real* q, Real* qd, Real* qdd, Level level, JacobianUpdate update) {
    if (update == JacobianUpdate::chord && has_factors_) {
      equations_->jacobian(q, values_.data());
      factors_are_old_ = true;
    } else if (!factor_at(q)) {
      return false;
    }
    equations_->known_jacobian(q, values_.data());
    if (!velocity(qd)) return false;
    if (level == Level::velocity) return true;
    if (per_level_ && !factor_at(q)) return false;
    return acceleration(q, qd, qdd);
  }

  bool velocity(Real* qd) {
    b_.setZero();
    subtract_known_product(qd);        // −Φ_h ḣ
    if (!solve_rates()) return false;  // eq. (3)
    scatter(qd);
    return true;
  }

  bool acceleration(const Real* q, const Real* qd, Real* qdd) {
    equations_->quadratic(q, qd, b_.data());
    b_ = -b_;                          // −Φ̇_q q̇
    subtract_known_product(qdd);       // −Φ_h ḧ
    if (!solve_rates()) return false;  // eq. (4)
    scatter(qdd);
    return true;
  }

  /// b_ = Φ_φ⁻¹ b_ with the Jacobian in values_, whatever was factorised.
  bool solve_rates() {
    if (refines() && (rounds_factors_ || factors_are_old_)) {
      if (refined()) return true;
      if (!factors_are_old_ || !factor()) return false;
      if (rounds_factors_) return refined();
    }
    equilibrated_.solve(*linear_solver_, b_.data());
    return true;
  }

  bool refined() {
    return refinement_.solve(
        pattern_, values_.data(), [this](Real* b) { equilibrated_.solve(*linear_solver_, b); },
        break_even_solves_, b_);
  }

  // Parts are small and these are called in every iteration: the compiler is told to inline them,
  // since it decides otherwise as soon as the surroundings change.
  [[gnu::always_inline]] bool factor_at(const Real* q) {
    equations_->jacobian(q, values_.data());
    return factor();
  }
  [[gnu::always_inline]] bool factor() {
    factors_are_old_ = false;
    return has_factors_ = linear_solver_->factor(equilibrated_.matrix(values_.data()));
  }

  void subtract_known_product(const Real* rate) {
    const Real* value = values_.data() + pattern_.dependent_entries();
    for (const JacobianEntry& e : pattern_.known) b_[e.row] -= *value++ * rate[e.state];
  }

  [[gnu::always_inline]] void scatter(Real* target) const {
    each_unknown([&](int at, int i) { target[at] = b_[i]; });
  }
  void remember_start(const Real* q) {
    each_unknown([&](int at, int i) { start_[i] = q[at]; });
  }
  void restore_start(Real* q) const {
    each_unknown([&](int at, int i) { q[at] = start_[i]; });
  }

  /// Calls with the place of each unknown in the state, and its own.
  template <class Call>
  [[gnu::always_inline]] void each_unknown(Call call) const {
    if (ranges_.empty())
      for (int i = 0; i < pattern_.n; ++i) call(pattern_.unknowns[i], i);
    int i = 0;
    for (const IndexRange range : ranges_) {
      const int shift = i - range.first;
      for (int at = range.first; at < range.end; ++at) call(at, at + shift);
      i += range.end - range.first;
    }
  }

  std::unique_ptr<const Equations<Real>> equations_;
  const Pattern& pattern_;
  Equilibration<Real> equilibrated_;
  std::unique_ptr<LinearSolver<Real>> linear_solver_;
  int break_even_solves_;
  bool rounds_factors_, reuses_pivots_;  // see LinearSolver
  JacobianUpdate update_;
  bool per_level_;
  double tolerance_;
  int min_iterations_, max_iterations_;
  bool at_rounding_;                // see PartSettings
  std::vector<IndexRange> ranges_;  // see long_ranges
  std::vector<Real> values_;        // Φ_φ and Φ_h, laid out by the pattern
  Vector weights_;
  Vector b_;           // right-hand side, then solution
  Vector correction_;  // the last one by old factors
  Vector start_;       // unknowns at the start of the step
  bool has_factors_ = false;
  bool factors_are_old_ = false;  // the values are of another position than the factors
  Refinement<Real> refinement_;
};

}  // namespace desmo
