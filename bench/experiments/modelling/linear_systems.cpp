#include "bench/experiments/modelling/linear_systems.h"

#include <memory>
#include <stdexcept>
#include <vector>

#include "formulations/algebra/condensation.h"
#include "formulations/equations/automatic.h"
#include "formulations/formulation.h"
#include "formulations/model/partition.h"
#include "formulations/variants.h"
#include "formulations/verification/condition.h"

namespace desmo::modelling {

LinearSystems linear_systems(const Model& m, Partition partition) {
  LinearSystems sum;
  for (const PartDefinition& part : make_partition(m, partition)) {
    if (part.constant) continue;
    const AutomaticEquations equations(m, part);
    const std::vector<Derivation> derived = derivations(m, part);
    sum.unknowns += static_cast<int>(part.unknowns.size() - derived.size());
    if (derived.empty()) {
      sum.entries += equations.pattern().dependent_entries();
      continue;
    }
    const Condensed condensed(equations.pattern(), derived,
                              [](const Pattern&) { return std::unique_ptr<LinearSolver>(); });
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
