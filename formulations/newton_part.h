#pragma once

#include <span>
#include <utility>

#include "formulations/newton_solver.h"
#include "formulations/part.h"

namespace desmo {

/// A part solved by Newton–Raphson in double precision (see NewtonSolver).
template <class Equations, class Algebra>
class NewtonPart final : public Part {
 public:
  template <class... AlgebraArguments>
  NewtonPart(Equations equations, std::span<const double> weights,
             std::span<const double> magnitudes, const PartSettings& settings,
             AlgebraArguments&&... arguments)
      : solver_(std::move(equations), weights, magnitudes, settings, arguments...) {}

  PartResult solve(State& s, std::span<const double>, Level level) override {
    return solver_.solve(s.q.data(), s.qd.data(), s.qdd.data(), level);
  }
  long refactorisations() const override { return solver_.refactorisations(); }

 private:
  NewtonSolver<Equations, Algebra> solver_;
};

}  // namespace desmo
