#include "formulations/newton_part.h"

#include <utility>

#include "formulations/algebra/backend.h"
#include "formulations/equations/automatic.h"
#include "formulations/newton_solver.h"
#include "formulations/profiled.h"
#include "formulations/single_precision_part.h"

namespace desmo {

namespace {

/// A part solved by Newton–Raphson in double precision.
class NewtonPart final : public Part {
 public:
  NewtonPart(std::unique_ptr<const Equations<double>> equations, const PartContext& c,
             std::unique_ptr<LinearSolver<double>> linear_solver)
      : solver_(std::move(equations), c.weights, c.magnitudes, c.settings,
                std::move(linear_solver)) {}

  PartResult solve(State& s, std::span<const double>, Level level) override {
    return solver_.solve(s.q.data(), s.qd.data(), s.qdd.data(), level);
  }
  long refactorisations() const override { return solver_.refactorisations(); }
  bool reuses_pivots() const override { return solver_.reuses_pivots(); }

 private:
  NewtonSolver<double> solver_;
};

std::unique_ptr<const Equations<double>> make_equations(const PartContext& c) {
  if (!c.kernels) return std::make_unique<AutomaticEquations>(c.mechanism, c.definition);
  return std::make_unique<SymbolicEquations>(c.mechanism, c.definition, *c.kernels);
}

}  // namespace

std::unique_ptr<Part> make_newton_part(const PartContext& c, const Backend& backend) {
  if (c.settings.scalar == Scalar::single_precision) return make_single_precision_part(c, backend);
  std::unique_ptr<const Equations<double>> equations = make_equations(c);
  std::unique_ptr<LinearSolver<double>> solver =
      backend.make_solver(equations->pattern(), c.settings);
  if (c.profile) {
    equations = std::make_unique<ProfiledEquations<double>>(std::move(equations), *c.profile);
    solver = std::make_unique<ProfiledSolver<double>>(std::move(solver), *c.profile);
  }
  return std::make_unique<NewtonPart>(std::move(equations), c, std::move(solver));
}

}  // namespace desmo
