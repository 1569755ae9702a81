#include "formulations/parts/newton_part.h"

#include <utility>
#include <vector>

#include "formulations/algebra/backend.h"
#include "formulations/algebra/condensation.h"
#include "formulations/equations/automatic.h"
#include "formulations/parts/newton_solver.h"
#include "formulations/parts/profiled.h"

namespace desmo {

namespace {

std::unique_ptr<const Equations> make_equations(const PartContext& c) {
  if (!c.kernels) return std::make_unique<AutomaticEquations>(c.model, c.definition);
  return std::make_unique<SymbolicEquations>(c.model, c.definition, *c.kernels);
}

/// Makes a solver of the part's linear systems, of what is not derived.
std::unique_ptr<LinearSolver> make_linear_solver(const PartContext& c, const Pattern& pattern,
                                                 const Backend& backend) {
  const auto make = [&](const Pattern& p) { return backend.make_solver(p, c.analysis); };
  const std::vector<Derivation> derived = derivations(c.model, c.definition);
  if (derived.empty()) return make(pattern);
  return std::make_unique<Condensed>(pattern, derived, make);
}

}  // namespace

std::unique_ptr<Part> make_newton_part(const PartContext& c, const Backend& backend) {
  std::unique_ptr<const Equations> equations = make_equations(c);
  std::unique_ptr<LinearSolver> solver = make_linear_solver(c, equations->pattern(), backend);
  if (c.profile) {
    equations = std::make_unique<ProfiledEquations>(std::move(equations), *c.profile);
    solver = std::make_unique<ProfiledSolver>(std::move(solver), *c.profile);
  }
  return std::make_unique<NewtonSolver>(std::move(equations), c.weights, c.magnitudes, c.settings,
                                        std::move(solver));
}

}  // namespace desmo
