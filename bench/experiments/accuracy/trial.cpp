#include "bench/experiments/accuracy/trial.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <utility>

#include "bench/kit/delivery.h"
#include "bench/kit/time/cpu_clock.h"
#include "formulations/verification/violation.h"

namespace desmo::accuracy {

namespace {

constexpr std::size_t violations_looked_at = 5;  // an instant costs as much as many steps

class Both final : public Observer {
 public:
  Both(Observer& first, Observer& second) : first_(first), second_(second) {}
  void observe(const Instant& instant) override {
    first_.observe(instant);
    second_.observe(instant);
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

Trial::Trial(const Problem& problem, const Configuration& configuration)
    : problem_(problem), configuration_(configuration) {
  if (std::string why = unsupported_reason(*configuration.variant, configuration.settings);
      !why.empty())
    stop(State::not_applicable, std::move(why));
}

void Trial::compare() {
  if (state != State::untried) return;
  const Plan& plan = problem_.plan;
  try {
    formulation_ = make_formulation(*configuration_.variant, plan.model, configuration_.settings,
                                    nullptr, &problem_.kernels);
    formulation_->solve_only(plan.levels);
    const Reference& reference = problem_.reference;
    const std::vector<double> times = some_times(reference);
    ErrorMeasure errors(plan.model, reference.instants, reference.scales, plan.outputs);
    ViolationMeasure violations(plan.model, reference.scales, times);
    Both both(errors, violations);
    const Summary summary = formulation_->run(problem_.grid, {plan.level()}, both);
    error = errors.error();
    violation = violations.violation();
    iterations_per_step = static_cast<double>(summary.iterations) /
                          static_cast<double>(std::max(1L, summary.instants));
    if (!summary.ok()) return stop(State::failed, describe(summary, plan.model));
    state = State::solved;
  } catch (const std::exception& e) {
    stop(State::failed, e.what());
  }
}

void Trial::time(double least) {
  if (state != State::solved) return;
  bench::Delivery delivery(problem_.plan.model.coordinates());
  const double start = bench::cpu_now();
  double spent = 0;
  long instants = 0;
  do {
    const Summary summary = formulation_->run(problem_.grid, {problem_.plan.level()}, delivery);
    if (!summary.ok()) return stop(State::failed, describe(summary, problem_.plan.model));
    instants += summary.instants;
    spent = bench::cpu_now() - start;
  } while (spent < least);
  seconds_per_step.push_back(spent / static_cast<double>(instants));
}

double Trial::min_seconds() const {
  return seconds_per_step.empty() ? std::numeric_limits<double>::infinity()
                                  : std::ranges::min(seconds_per_step);
}

void Trial::stop(State reached, std::string why) {
  state = reached;
  message = std::move(why);
  seconds_per_step.clear();
}

}  // namespace desmo::accuracy
