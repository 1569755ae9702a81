#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include "formulations/base/part.h"
#include "formulations/parts/exact_frames.h"
#include "formulations/parts/jacobian_factors.h"
#include "formulations/parts/part_unknowns.h"

namespace desmo {

/// The rule that accepts a position, whatever factors led there. It accepts the first one whose ‖Φ‖
/// is below PartSettings::stop. After the last iteration, PartSettings::accept is the limit. With
/// PartSettings::at_rounding one more correction is made first, unless all iterations are done.
class Acceptance {
 public:
  explicit Acceptance(const PartSettings& limits)
      : limits_(limits), is_last_(!limits.at_rounding) {}

  /// Returns whether the position is accepted. Notes that a limit was met. residual: weighted ‖Φ‖
  /// of the position; iterations: number of those that led to it.
  bool update(double residual, int iterations) {
    const bool is_over = iterations == limits_.max_iterations;
    if (!(residual < (is_over ? limits_.accept : limits_.stop))) return false;
    return std::exchange(is_last_, true) || is_over;
  }

 private:
  const PartSettings& limits_;
  bool is_last_;
};

/// A part solved by Newton–Raphson on its equations (paper, Fig. 2b), for every way of evaluating
/// equations and of solving linear systems. JacobianFactors decides when Φ_φ is factorised. While
/// iterations are left, a correction by old factors is taken back unless it made ‖Φ‖ smaller or met
/// the tolerance. One that led to NaN is taken back, too.
///
/// A step that fails is tried a second time, from the same prediction, where factors or a pivot
/// order may have been old. The second attempt discards both and factorises in every iteration.
///
/// FrameMethod: LinearisedFrames or ExactFrames, which evaluates derived unknowns in an iteration.
template <class FrameMethod>
class NewtonSolverOf final : public Part {
 public:
  /// - weights: 1/magnitude of each equation, so that ‖Φ‖₂ does not depend on units
  /// - magnitudes: one for each unknown; empty: all are 1
  /// - linear_solver: made for the pattern of these equations
  NewtonSolverOf(std::unique_ptr<const Equations> equations, std::span<const double> weights,
                 std::span<const double> magnitudes, const PartSettings& settings,
                 std::unique_ptr<LinearSolver> linear_solver, FrameMethod frames = {})
      : equations_(std::move(equations)),
        pattern_(equations_->pattern()),
        unknowns_(pattern_.unknowns),
        settings_(settings),
        reuses_pivots_(linear_solver->pivots().reuse_order),
        weights_(Eigen::Map<const Eigen::VectorXd>(weights.data(), pattern_.n)),
        factors_(*equations_, weights, magnitudes, settings_.accept, std::move(linear_solver)),
        b_(pattern_.n),
        correction_(pattern_.n),
        start_(pattern_.n),
        frames_(std::move(frames)) {}

  void forget() override { frames_.forget(); }
  void end_assembly() override { frames_.end_assembly(); }

  PartCounts counts() const override {
    return {.refactorisations = std::max(0L, factors_.solver().pivots().choices - 1)};
  }

  PartResult solve(State& state, std::span<const double>, Level level) override {
    double *const q = state.q.data(), *const qd = state.qd.data(), *const qdd = state.qdd.data();
    if (!reuses_pivots_ && settings_.jacobian == JacobianUpdate::newton)
      return attempt(q, qd, qdd, level, settings_.jacobian);
    unknowns_.for_each([&](int at, int i) { start_[i] = q[at]; });
    const PartResult first = attempt(q, qd, qdd, level, settings_.jacobian);
    if (first.status == Status::solved) return first;
    // Perhaps only the factors, or their pivots, had gone bad.
    unknowns_.for_each([&](int at, int i) { q[at] = start_[i]; });
    factors_.forget();
    PartResult second = attempt(q, qd, qdd, level, JacobianUpdate::newton);
    second.iterations += first.iterations;
    return second;
  }

 private:
  PartResult attempt(double* q, double* qd, double* qdd, Level level, JacobianUpdate update) {
    factors_.begin_position(update);
    PartResult result = frames_.choose([&](auto& frames) { return position(q, frames); });
    if (result.status != Status::solved) return result;
    if (level == Level::position)
      factors_.end_at_position();
    else if (!rates(q, qd, qdd, level))
      result.status = Status::singular;
    return result;
  }

  // ---- The paper's Fig. 2b ----

  /// Newton's method: repeats φ ← φ − Φ_φ⁻¹ Φ until Φ is accepted, the iterations are spent, or Φ
  /// is not finite. Takes back a correction by old factors that led away.
  template <class Chosen>
  PartResult position(double* q, Chosen& frames) {
    PartResult result;
    Acceptance acceptance(settings_);
    for (;; ++result.iterations) {
      frames.residual(*equations_, q, b_);  // Φ
      const double residual = weights_.cwiseProduct(b_).norm();
      result.residual2 = residual * residual;
      if (acceptance.update(residual, result.iterations)) return result;
      const bool is_over = result.iterations == settings_.max_iterations;
      if (!is_over && factors_.led_away(residual)) {
        retract(q);
        continue;
      }
      if (is_over || !std::isfinite(residual))
        return failure(result,
                       std::isfinite(residual) ? Status::not_converged : Status::not_finite);
      if (!factors_.prepare_correction(q, residual)) return failure(result, Status::singular);
      frames.solve(factors_, b_);                                  // Φ_φ Δφ = Φ
      unknowns_.for_each([&](int at, int i) { q[at] -= b_[i]; });  // eq. (2)
      if (factors_.corrects_with_old()) b_.swap(correction_);      // kept for retract()
    }
  }

  bool rates(const double* q, double* qd, double* qdd, Level level) {
    if (!factors_.factor_at(q)) return false;
    factors_.evaluate_known(q);
    velocity(qd);
    if (level == Level::acceleration) acceleration(q, qd, qdd);
    return true;
  }

  void velocity(double* qd) {
    b_.setZero();
    subtract_known_product(qd);  // −Φ_h ḣ
    factors_.solve(b_);          // eq. (3)
    scatter(qd);
  }

  void acceleration(const double* q, const double* qd, double* qdd) {
    equations_->quadratic(q, qd, b_.data());
    b_ = -b_;                     // −Φ̇_q q̇
    subtract_known_product(qdd);  // −Φ_h ḧ
    factors_.solve(b_);           // eq. (4)
    scatter(qdd);
  }

  static PartResult failure(PartResult result, Status status) {
    result.status = status;
    return result;
  }

  /// Takes back a correction that old factors gave, and gives these up.
  void retract(double* q) {
    unknowns_.for_each([&](int at, int i) { q[at] += correction_[i]; });
    factors_.give_up();
  }

  void subtract_known_product(const double* rate) {
    const double* value = factors_.values() + pattern_.dependent_entries();
    for (const JacobianEntry& e : pattern_.known) b_[e.row] -= *value++ * rate[e.place];
  }

  [[gnu::always_inline]] void scatter(double* target) const {
    unknowns_.for_each([&](int at, int i) { target[at] = b_[i]; });
  }

  std::unique_ptr<const Equations> equations_;
  const Pattern& pattern_;
  PartUnknowns unknowns_;
  PartSettings settings_;
  bool reuses_pivots_;
  Eigen::VectorXd weights_;
  JacobianFactors factors_;
  Eigen::VectorXd b_;           // right-hand side, then solution
  Eigen::VectorXd correction_;  // last correction by old factors
  Eigen::VectorXd start_;       // unknowns at the start of the step
  FrameMethod frames_;
};

using NewtonSolver = NewtonSolverOf<LinearisedFrames>;

}  // namespace desmo
