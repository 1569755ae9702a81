#include "bench/experiments/accuracy/trial.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "formulations/verification/condition.h"
#include "formulations/verification/violation.h"

namespace desmo::accuracy {

namespace {

constexpr std::size_t violations_looked_at = 5;  // an instant costs as much as many steps

class Both final : public Observer {
 public:
  Both(Observer& first, Observer& second) : first_(first), second_(second) {}
  Flow observe(const Instant& instant) noexcept override {
    first_.observe(instant);
    return second_.observe(instant);
  }

 private:
  Observer &first_, &second_;
};

std::vector<double> some_times(const Reference& reference) {
  const std::size_t count = std::min(reference.instants.size(), violations_looked_at);
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i)
    times.push_back(reference.instants[i * (reference.instants.size() - 1) / (count - 1)].time);
  return times;
}

}  // namespace

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
    leave_out(std::move(why));
}

void Trial::compare() {
  verify_by([&](bench::VerifyingRun& found) -> std::string {
    const Plan& plan = problem().plan;
    build();
    const Reference& reference = problem().reference;
    const std::vector<double> times = some_times(reference);
    ErrorMeasure errors(plan.model, reference.instants, reference.scales, plan.outputs);
    ViolationMeasure violations(plan.model, reference.scales, times);
    Both both(errors, violations);
    const Summary summary = formulation_->run(grid, asked_, both);
    error = errors.error();
    violation = violations.violation();
    found.iterations_per_step = static_cast<double>(summary.iterations) /
                                static_cast<double>(std::max(1L, summary.instants));
    return summary.ok() ? "" : describe(summary, plan.model);
  });
}

void Trial::time(double duration) {
  measure([&] { add_sample(step_seconds(duration)); });
}

}  // namespace desmo::accuracy
