#include "bench/experiments/accuracy/trial.h"

#include <algorithm>
#include <string>
#include <utility>

#include "formulations/verification/condition.h"

namespace desmo::accuracy {

double max_condition(const Problem& problem) {
  ConditionNumber number(problem.plan.model);
  double max = 0;
  for (const ReferenceInstant& instant : problem.reference.instants)
    max = std::max(max, number(instant.q));
  return max;
}

Trial::Trial(const Problem& problem, const Configuration& configuration)
    : FormulationCandidate(problem, configuration) {
  if (std::string why = unsupported_reason(variant(), settings()); !why.empty())
    refuse(not_run(std::move(why)));
}

Trial::Checked Trial::check(bench::VerifyingRun& found) {
  const Plan& plan = problem().plan;
  formulation_ = make_formulation();
  const Reference& reference = problem().reference;
  ErrorMeasure errors(plan.model, reference.instants, reference.scales, plan.outputs);
  const Summary summary = formulation_->run(grid(), request_, errors);
  error = errors.error();
  found.iterations_per_step =
      static_cast<double>(summary.iterations) / static_cast<double>(std::max(1L, summary.instants));
  if (summary.ok()) return {};
  return failed(describe(summary, plan.model));
}

void Trial::time(double duration) {
  measure([&] { add_sample(step_seconds(*formulation_, duration)); });
}

}  // namespace desmo::accuracy
