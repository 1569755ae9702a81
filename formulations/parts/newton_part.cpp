#include "formulations/parts/newton_part.h"

#include <algorithm>
#include <utility>

#include "formulations/algebra/backend.h"
#include "formulations/equations/automatic.h"
#include "formulations/parts/newton_solver.h"
#include "formulations/parts/profiled.h"

namespace desmo {

namespace {

/// A part solved by Newton–Raphson in double precision.
class DoublePrecisionPart final : public Part {
 public:
  DoublePrecisionPart(std::unique_ptr<const Equations<double>> equations, const PartContext& c,
                      std::unique_ptr<LinearSolver<double>> linear_solver)
      : solver_(std::move(equations), c.weights, c.magnitudes, c.settings,
                std::move(linear_solver)) {}

  PartResult solve(State& s, std::span<const double>, Level level) override {
    return solver_.solve(s.q.data(), s.qd.data(), s.qdd.data(), level);
  }
  PartCounts counts() const override {
    return {.refactorisations = std::max(0L, solver_.pivots().choices - 1)};
  }
  Pivots pivots() const override { return solver_.pivots(); }

 private:
  NewtonSolver<double> solver_;
};

/// A part solved in single precision: what it reads of the state is rounded, and what it finds are
/// single numbers, kept in the double ones of the state.
class SinglePrecisionPart final : public Part {
 public:
  SinglePrecisionPart(std::unique_ptr<const Equations<float>> equations, const PartContext& c,
                      std::unique_ptr<LinearSolver<float>> linear_solver)
      : solver_(std::move(equations), c.weights, c.magnitudes, c.settings,
                std::move(linear_solver)),
        state_(c.single),
        read_(states_read(c.model, c.definition)) {}

  PartResult solve(State& s, std::span<const double>, Level level) override {
    for (const int i : read_) {
      state_->q[i] = static_cast<float>(s.q[i]);
      state_->qd[i] = static_cast<float>(s.qd[i]);
      state_->qdd[i] = static_cast<float>(s.qdd[i]);
    }
    const PartResult result =
        solver_.solve(state_->q.data(), state_->qd.data(), state_->qdd.data(), level);
    for (const int i : solver_.pattern().unknowns) {
      s.q[i] = state_->q[i];
      s.qd[i] = state_->qd[i];
      s.qdd[i] = state_->qdd[i];
    }
    return result;
  }

 private:
  NewtonSolver<float> solver_;
  std::shared_ptr<SinglePrecisionState> state_;
  std::vector<int> read_;  // positions in the state of all that the equations read
};

std::unique_ptr<const Equations<double>> make_equations(const PartContext& c) {
  if (!c.kernels) return std::make_unique<AutomaticEquations>(c.model, c.definition);
  return std::make_unique<SymbolicEquations>(c.model, c.definition, *c.kernels);
}

template <class NewtonPart, class Real>
std::unique_ptr<Part> make_part(const PartContext& c,
                                std::unique_ptr<const Equations<Real>> equations,
                                std::unique_ptr<LinearSolver<Real>> solver) {
  if (c.profile) {
    equations = std::make_unique<ProfiledEquations<Real>>(std::move(equations), *c.profile);
    solver = std::make_unique<ProfiledSolver<Real>>(std::move(solver), *c.profile);
  }
  return std::make_unique<NewtonPart>(std::move(equations), c, std::move(solver));
}

}  // namespace

std::unique_ptr<Part> make_newton_part(const PartContext& c, const Backend& backend) {
  if (c.analysis.scalar == Scalar::single_precision) {
    std::unique_ptr<const Equations<float>> equations =
        std::make_unique<BasicAutomaticEquations<float>>(c.model, c.definition);
    auto solver = backend.make_single_solver(equations->pattern());
    return make_part<SinglePrecisionPart>(c, std::move(equations), std::move(solver));
  }
  std::unique_ptr<const Equations<double>> equations = make_equations(c);
  auto solver = backend.make_solver(equations->pattern(), c.analysis);
  return make_part<DoublePrecisionPart>(c, std::move(equations), std::move(solver));
}

}  // namespace desmo
