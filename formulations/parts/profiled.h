#pragma once

#include <memory>
#include <utility>

#include "formulations/algebra/linear_solver.h"
#include "formulations/equations/equations.h"
#include "formulations/parts/profile.h"

namespace desmo {

/// Equations whose evaluations are measured, so that the solvers need no timers.
class ProfiledEquations final : public Equations {
 public:
  ProfiledEquations(std::unique_ptr<const Equations> equations, Profile& profile)
      : equations_(std::move(equations)), profile_(profile) {}

  const Pattern& pattern() const override { return equations_->pattern(); }
  void constant_jacobian(double* values) const override { equations_->constant_jacobian(values); }
  void residual(const double* q, double* phi) const override {
    profile_.measure(Phase::residual, [&] { equations_->residual(q, phi); });
  }
  void jacobian(const double* q, double* values) const override {
    profile_.measure(Phase::jacobian, [&] { equations_->jacobian(q, values); });
  }
  void known_jacobian(const double* q, double* values) const override {
    profile_.measure(Phase::right_hand_sides, [&] { equations_->known_jacobian(q, values); });
  }
  void quadratic(const double* q, const double* qd, double* gamma) const override {
    profile_.measure(Phase::right_hand_sides, [&] { equations_->quadratic(q, qd, gamma); });
  }

 private:
  std::unique_ptr<const Equations> equations_;
  Profile& profile_;
};

/// A linear solver whose factorisations and solutions are measured.
class ProfiledSolver final : public LinearSolver {
 public:
  ProfiledSolver(std::unique_ptr<LinearSolver> solver, Profile& profile)
      : solver_(std::move(solver)), profile_(profile) {}

  bool factor(const double* values) override {
    return profile_.measure(Phase::factorisation, [&] { return solver_->factor(values); });
  }
  void solve(double* b) override {
    profile_.measure(Phase::solve, [&] { solver_->solve(b); });
  }
  void solve_closures(double* b) override {
    profile_.measure(Phase::solve, [&] { solver_->solve_closures(b); });
  }
  int break_even_solves() const override { return solver_->break_even_solves(); }
  Pivots pivots() const override { return solver_->pivots(); }
  void forget_pivots() override { solver_->forget_pivots(); }

 private:
  std::unique_ptr<LinearSolver> solver_;
  Profile& profile_;
};

}  // namespace desmo
