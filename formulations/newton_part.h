#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "formulations/equations/pattern.h"
#include "formulations/part.h"

namespace desmo {

/// Newton–Raphson on a part's equations (paper, Fig. 2b), for every way of evaluating equations
/// and of solving linear systems.
///
/// Equations: see AutomaticEquations. Algebra has
///   Algebra(const Pattern&)              analyses the structure of Φ_φ, allocates
///   bool factor(const double* values)    factorises Φ_φ; false when singular
///   void solve(double* b)                b = Φ_φ⁻¹ b with the last factors
///   static constexpr bool keeps_pivots   whether factor() reuses an earlier order of pivots
///   void forget_pivots()                 the next factor() chooses them anew
template <class Equations, class Algebra>
class NewtonPart final : public Part {
 public:
  /// settings: with the tolerance on ‖Φ‖₂ of the part's own equations. Further arguments go to
  /// the algebra.
  template <class... AlgebraArguments>
  NewtonPart(Equations equations, const Settings& settings, AlgebraArguments&&... arguments)
      : equations_(std::move(equations)),
        algebra_(equations_.pattern(), arguments...),
        tolerance_(settings.fixed_iterations ? std::numeric_limits<double>::infinity()
                                             : settings.tolerance),
        least_iterations_(settings.fixed_iterations),
        most_iterations_(settings.fixed_iterations ? settings.fixed_iterations
                                                   : settings.max_iterations),
        values_(equations_.pattern().size(), 0.0),
        b_(equations_.pattern().n),
        start_(equations_.pattern().n) {
    equations_.constant_jacobian(values_.data());
  }

  PartResult solve(State& state, Level level) override {
    if constexpr (Algebra::keeps_pivots) {
      remember_start(state.q.data());
      const PartResult result = attempt(state, level);
      if (result.status == Status::converged) return result;
      restore_start(state.q.data());  // perhaps only the pivots had gone bad
      algebra_.forget_pivots();
    }
    return attempt(state, level);
  }

 private:
  const Pattern& pattern() const { return equations_.pattern(); }

  PartResult attempt(State& s, Level level) {
    PartResult result = position(s.q.data());
    if (level == Level::position || result.status != Status::converged) return result;
    if (!factor_at(s.q.data())) {
      result.status = Status::singular;
      return result;
    }
    equations_.known_jacobian(s.q.data(), values_.data());
    velocity(s.qd.data());
    if (level == Level::acceleration) acceleration(s.q.data(), s.qd.data(), s.qdd.data());
    return result;
  }

  PartResult position(double* q) {
    PartResult result;
    for (;; ++result.iterations) {
      equations_.residual(q, b_.data());  // Φ
      result.residual = b_.norm();
      if (result.residual < tolerance_ && result.iterations >= least_iterations_) return result;
      if (!std::isfinite(result.residual))
        result.status = Status::not_finite;
      else if (result.iterations == most_iterations_)
        result.status = Status::not_converged;
      else if (!factor_at(q))
        result.status = Status::singular;
      if (result.status != Status::converged) return result;
      algebra_.solve(b_.data());                                                // Φ_φ Δφ = Φ
      for (int i = 0; i < pattern().n; ++i) q[pattern().unknowns[i]] -= b_[i];  // eq. (2)
    }
  }

  void velocity(double* qd) {
    b_.setZero();
    subtract_known_product(qd);  // −Φ_h ḣ
    algebra_.solve(b_.data());   // eq. (3)
    scatter(qd);
  }

  void acceleration(const double* q, const double* qd, double* qdd) {
    equations_.quadratic(q, qd, b_.data());
    b_ = -b_;                     // −Φ̇_q q̇
    subtract_known_product(qdd);  // −Φ_h ḧ
    algebra_.solve(b_.data());    // eq. (4)
    scatter(qdd);
  }

  bool factor_at(const double* q) {
    equations_.jacobian(q, values_.data());
    return algebra_.factor(values_.data());
  }

  void subtract_known_product(const double* rate) {
    const double* value = values_.data() + pattern().dependent_entries();
    for (const JacobianEntry& e : pattern().known) b_[e.row] -= *value++ * rate[e.state];
  }

  void scatter(double* target) const {
    for (int i = 0; i < pattern().n; ++i) target[pattern().unknowns[i]] = b_[i];
  }

  void remember_start(const double* q) {
    for (int i = 0; i < pattern().n; ++i) start_[i] = q[pattern().unknowns[i]];
  }
  void restore_start(double* q) const {
    for (int i = 0; i < pattern().n; ++i) q[pattern().unknowns[i]] = start_[i];
  }

  Equations equations_;
  Algebra algebra_;
  double tolerance_;
  int least_iterations_, most_iterations_;
  std::vector<double> values_;  // Φ_φ and Φ_h, laid out by the pattern
  Eigen::VectorXd b_;           // right-hand side, then solution
  std::vector<double> start_;   // unknowns at the start of the step
};

}  // namespace desmo
