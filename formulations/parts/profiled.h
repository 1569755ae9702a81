#pragma once

#include <memory>
#include <utility>

#include "formulations/algebra/linear_solver.h"
#include "formulations/equations/equations.h"
#include "formulations/parts/profile.h"

namespace desmo {

/// Equations whose evaluations are measured, so that no solver has a timer inside.
template <class Real>
class ProfiledEquations final : public Equations<Real> {
 public:
  ProfiledEquations(std::unique_ptr<const Equations<Real>> equations, Profile& profile)
      : equations_(std::move(equations)), profile_(profile) {}

  const Pattern& pattern() const override { return equations_->pattern(); }
  void constant_jacobian(Real* values) const override { equations_->constant_jacobian(values); }
  void residual(const Real* q, Real* phi) const override {
    profile_.measure(Phase::residual, [&] { equations_->residual(q, phi); });
  }
  void jacobian(const Real* q, Real* values) const override {
    profile_.measure(Phase::jacobian, [&] { equations_->jacobian(q, values); });
  }
  void known_jacobian(const Real* q, Real* values) const override {
    profile_.measure(Phase::right_hand_sides, [&] { equations_->known_jacobian(q, values); });
  }
  void quadratic(const Real* q, const Real* qd, Real* gamma) const override {
    profile_.measure(Phase::right_hand_sides, [&] { equations_->quadratic(q, qd, gamma); });
  }

 private:
  std::unique_ptr<const Equations<Real>> equations_;
  Profile& profile_;
};

/// A linear solver whose factorisations and solutions are measured.
template <class Real>
class ProfiledSolver final : public LinearSolver<Real> {
 public:
  ProfiledSolver(std::unique_ptr<LinearSolver<Real>> solver, Profile& profile)
      : solver_(std::move(solver)), profile_(profile) {}

  bool factor(const Real* values) override {
    return profile_.measure(Phase::factorisation, [&] { return solver_->factor(values); });
  }
  void solve(Real* b) override {
    profile_.measure(Phase::solve, [&] { solver_->solve(b); });
  }
  int break_even_solves() const override { return solver_->break_even_solves(); }
  bool rounds_factors() const override { return solver_->rounds_factors(); }
  Pivots pivots() const override { return solver_->pivots(); }
  void forget_pivots() override { solver_->forget_pivots(); }

 private:
  std::unique_ptr<LinearSolver<Real>> solver_;
  Profile& profile_;
};

}  // namespace desmo
