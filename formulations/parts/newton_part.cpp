#include "formulations/parts/newton_part.h"

#include <span>
#include <utility>
#include <vector>

#include "formulations/algebra/backend.h"
#include "formulations/algebra/condensation.h"
#include "formulations/equations/automatic.h"
#include "formulations/parts/exact_frames.h"
#include "formulations/parts/newton_solver.h"
#include "formulations/parts/profiled.h"

namespace desmo {

namespace {

std::unique_ptr<const Equations> make_equations(const PartContext& c) {
  if (!c.kernels) return std::make_unique<AutomaticEquations>(c.model, c.definition);
  return std::make_unique<SymbolicEquations>(c.model, c.definition, *c.kernels);
}

/// Wraps equations in ones that are measured, where a profile is asked for.
std::unique_ptr<const Equations> measured(std::unique_ptr<const Equations> equations,
                                          const PartContext& c) {
  if (!c.profile) return equations;
  return std::make_unique<ProfiledEquations>(std::move(equations), *c.profile);
}

/// Makes a solver of the part's linear systems. It condenses derived unknowns, if there are any.
std::unique_ptr<LinearSolver> make_linear_solver(const PartContext& c, const Pattern& pattern,
                                                 std::span<const Derivation> derived,
                                                 const Backend& backend) {
  const auto make = [&](const Pattern& p) { return backend.make_solver(p, c.analysis); };
  if (derived.empty()) return make(pattern);
  return std::make_unique<Condensed>(pattern, derived, make);
}

}  // namespace

std::unique_ptr<Part> make_newton_part(const PartContext& c, const Backend& backend) {
  std::unique_ptr<const Equations> equations = make_equations(c);
  const std::vector<Derivation> derived = derivations(c.model, c.definition);
  std::unique_ptr<LinearSolver> solver =
      make_linear_solver(c, equations->pattern(), derived, backend);
  equations = measured(std::move(equations), c);
  if (c.profile) solver = std::make_unique<ProfiledSolver>(std::move(solver), *c.profile);
  if (c.analysis.frames == Frames::linearised || derived.empty())
    return std::make_unique<NewtonSolver>(std::move(equations), c.weights, c.magnitudes, c.settings,
                                          std::move(solver));
  ExactFrames frames(c.model, c.definition, derived, [&](const PartDefinition& d) {
    return measured(std::make_unique<AutomaticEquations>(c.model, d), c);
  });
  return std::make_unique<NewtonSolverOf<ExactFrames>>(std::move(equations), c.weights,
                                                       c.magnitudes, c.settings, std::move(solver),
                                                       std::move(frames));
}

}  // namespace desmo
