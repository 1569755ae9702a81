#include "formulations/parts/newton_part.h"

#include <utility>

#include "formulations/algebra/backend.h"
#include "formulations/equations/automatic.h"
#include "formulations/parts/newton_solver.h"
#include "formulations/parts/profiled.h"

namespace desmo {

namespace {

std::unique_ptr<const Equations> make_equations(const PartContext& c) {
  if (!c.kernels) return std::make_unique<AutomaticEquations>(c.model, c.definition);
  return std::make_unique<SymbolicEquations>(c.model, c.definition, *c.kernels);
}

}  // namespace

std::unique_ptr<Part> make_newton_part(const PartContext& c, const Backend& backend) {
  std::unique_ptr<const Equations> equations = make_equations(c);
  std::unique_ptr<LinearSolver> solver = backend.make_solver(equations->pattern(), c.analysis);
  if (c.profile) {
    equations = std::make_unique<ProfiledEquations>(std::move(equations), *c.profile);
    solver = std::make_unique<ProfiledSolver>(std::move(solver), *c.profile);
  }
  return std::make_unique<NewtonSolver>(std::move(equations), c.weights, c.magnitudes, c.settings,
                                        std::move(solver));
}

}  // namespace desmo
