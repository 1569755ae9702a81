#include "bench/experiments/modelling/problems.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "bench/kit/verification.h"
#include "formulations/algebra/condensation.h"
#include "formulations/equations/automatic.h"
#include "formulations/equations/kernel_sets.h"
#include "formulations/formulation.h"
#include "formulations/id.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/condition.h"

namespace desmo::modelling {

namespace {

constexpr int compared_instants = 11;

Plan whole(Model model) { return {std::move(model), {}, {}, {}}; }

/// Adds kernels that the program is linked with to a table, which does not own them.
void add(KernelTable& table, const KernelLibrary& library) {
  table.add(std::shared_ptr<const KernelLibrary>(&library, [](const KernelLibrary*) {}));
}

}  // namespace

std::string id_in(std::string_view id, Modelling kind, Frames frames) {
  const auto v = std::ranges::find(variants(), id, &Variant::id);
  if (v == variants().end()) return {};
  // Generated code for natural coordinates solves first what `basis` derives: it would be the same.
  if (kind == Modelling::basis && v->evaluation == Evaluation::symbolic) return {};
  // Exact frames save the same time with every solver. With fast ones it is a share of a step worth
  // measuring.
  if (frames == Frames::exact && v->algebra != "klu" && v->algebra != "lapack") return {};
  const Settings settings{.coordinates = kind, .frames = frames};
  return unsupported_reason(*v, settings).empty() ? id_with(*v, settings) : std::string();
}

bench::Problem natural_problem(const Scene& scene, const TimeGrid& grid) {
  bench::Problem problem = bench::make_problem(whole(make_model(scene)), grid, compared_instants);
  bench::require_agreement(problem.plan.model, problem.reference.floor);
  return problem;
}

bench::Problem problem_in(const Scene& scene, const bench::Problem& natural, Modelling kind) {
  if (kind == Modelling::natural) return natural;
  bench::Problem problem{
      .plan = whole(make_model(scene, kind)), .grid = natural.grid, .reference = natural.reference};
  const Model& m = problem.plan.model;
  for (const Entity& e : natural.plan.model.entities) {
    const Entity& same = m.entities[m.find(e.name)];
    if (e.fixed != same.fixed)
      throw std::runtime_error(m.name + ": '" + e.name + "' is at rest in some coordinates only");
    if (e.fixed) continue;
    for (int i = 0; i < e.size; ++i) problem.delivered.push_back(same.first + i);
  }
  add(problem.kernels, coordinates_kernels());
  add(problem.kernels, coordinates_explicit_kernels());
  return problem;
}

LinearSystems linear_systems(const Model& m, Partition partition) {
  LinearSystems sum;
  for (const PartDefinition& part : make_partition(m, partition)) {
    if (part.constant) continue;
    const AutomaticEquations equations(m, part);
    const Condensed condensed(equations.pattern(), derivations(m, part),
                              [](const Pattern&) { return std::unique_ptr<LinearSolver>(); });
    sum.unknowns += condensed.reduced_pattern().n;
    sum.entries += condensed.reduced_pattern().dependent_entries();
    sum.condensation += condensed.operations();
  }
  return sum;
}

double condition_at_start(const Model& m, double time) {
  const auto formulation = make_formulation(find_variant("group_automatic_lapack"), m,
                                            Settings{.coordinates = m.modelling});
  if (const Summary s = formulation->assemble(time); !s.ok())
    throw std::runtime_error(describe(s, m));
  return ConditionNumber(m)(formulation->q());
}

}  // namespace desmo::modelling
