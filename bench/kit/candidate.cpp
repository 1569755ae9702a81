#include "bench/kit/candidate.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <stdexcept>

#include "bench/kit/memory.h"
#include "formulations/variants.h"

namespace desmo::bench {

namespace {

/// Wall-clock time [s] after which threads are awake, and have all had a processor at the same
/// time.
constexpr double long_enough = 0.03;

}  // namespace

double Candidate::time_afresh() {
  double least = std::numeric_limits<double>::infinity();
  on_fresh_heap([&] {
    make();
    const double begin = now(clock);
    do {
      const double before = now(clock);
      static_cast<void>(analyse());  // a failure is noted
      least = std::min(least, now(clock) - before);
    } while (clock == Clock::wall && !is_failed() && now(clock) - begin < long_enough);
    discard();
  });
  return least;
}

void Candidate::wake_threads(const std::function<void()>& solve) const {
  const double begin = now(clock);
  while (clock == Clock::wall && now(clock) - begin < long_enough) solve();
}

void Candidate::verify_by(const std::function<std::string(VerifyingRun&)>& check) {
  if (readiness_ != Readiness::unverified) return;
  std::string wrong;
  try {
    wrong = check(verifying_run_);
  } catch (const std::exception& e) {
    wrong = e.what();
  }
  if (!wrong.empty())
    fail(std::move(wrong));
  else if (readiness_ == Readiness::unverified)
    readiness_ = Readiness::verified;
}

void Candidate::measure(const std::function<void()>& measurement) {
  if (!is_verified()) return;
  try {
    measurement();
  } catch (const std::exception& e) {
    fail(e.what());
  }
}

void Candidate::add_sample(double seconds) {
  if (!is_verified()) throw std::logic_error(name() + ": a sample of what is not verified");
  seconds_.push_back(seconds);
}

void Candidate::stop(Readiness reached, std::string why) {
  readiness_ = reached;
  message_ = std::move(why);
  seconds_.clear();
}

FormulationCandidate::FormulationCandidate(const Problem& problem, const Configuration& c)
    : FormulationCandidate(problem, id_with(*c.variant, c.settings), c) {}

FormulationCandidate::FormulationCandidate(const Problem& problem, std::string_view id,
                                           const Settings& others)
    : FormulationCandidate(problem, id, parse_id(id, others)) {}

FormulationCandidate::FormulationCandidate(const Problem& problem, std::string_view id,
                                           const Configuration& c)
    : Candidate(problem.grid, c.settings.threads),
      coordinates(problem.plan.model.coordinates()),
      asked_{problem.level(), {}},
      problem_(std::shared_ptr<void>(), &problem),
      case_name_(problem.plan.model.name),
      id_(id),
      configuration_(c),
      delivery_(delivered(), asked_.level, measured_windows()) {}

FormulationCandidate::FormulationCandidate(const TimeGrid& instants, std::string_view case_name,
                                           int n, const Configuration& c, Clock by,
                                           ProblemSource problem, Request asked)
    : Candidate(instants, c.settings.threads, by),
      coordinates(n),
      asked_(std::move(asked)),
      source_(std::move(problem)),
      case_name_(case_name),
      id_(id_with(*c.variant, c.settings)),
      configuration_(c),
      delivery_(delivered(), asked_.level, measured_windows()) {}

const Problem& FormulationCandidate::problem() const {
  if (!problem_) problem_ = source_();
  return *problem_;
}

std::string FormulationCandidate::name() const {
  return case_name_ + "/" + std::to_string(coordinates) + "/" + id();
}

void FormulationCandidate::build() {
  formulation_ = make_formulation(variant(), problem().plan.model, settings(), problem().kernels);
  if (!problem().plan.levels.empty()) formulation_->solve_only(problem().plan.levels);
}

void FormulationCandidate::verify() {
  verify_by([&](VerifyingRun& found) {
    return compare_with(
        [&] { return std::span<const ReferenceInstant>(problem().reference.instants); }, found);
  });
  discard();
}

void FormulationCandidate::verify(ReferenceCache& references) {
  verify_by([&](VerifyingRun& found) {
    return compare_with(
        [&] { return references.get(problem().plan.model, grid, settings().stride); }, found);
  });
}

std::string FormulationCandidate::compare_with(const ReferenceSource& reference,
                                               VerifyingRun& found) {
  if (const std::string reason = unavailable_reason(settings()); !reason.empty()) {
    leave_out(reason);
    return {};
  }
  const Model& model = problem().plan.model;
  const std::size_t bytes_before = heap_in_use();
  const double before_setup = cpu_now();
  build();
  found.setup_seconds = cpu_now() - before_setup;
  found.bytes = static_cast<long>(heap_in_use() - bytes_before);
  if (std::string missing = missing_code(*formulation_); !missing.empty()) return missing;

  const std::span<const ReferenceInstant> right = reference();
  const auto observer = comparing(right);
  const double start = now(clock);
  const Summary summary = formulation_->run(grid, asked_, *observer);
  found.analysis_seconds = now(clock) - start;
  const Comparison comparison = observer->compare();
  found.errors = comparison.errors;
  found.results = comparison.results;
  if (!summary.ok()) return describe(summary, model);
  found.iterations_per_step = static_cast<double>(summary.iterations) / summary.instants;
  found.residual = summary.residual;
  return verification_failure(found.errors, right.size(),
                              std::max(1.0, problem().tolerance / Settings{}.tolerance));
}

std::unique_ptr<ComparingObserver> FormulationCandidate::comparing(
    std::span<const ReferenceInstant> reference) const {
  return std::make_unique<VerifyingObserver>(reference);
}

void FormulationCandidate::make() {
  build();
  static_cast<void>(formulation_->assemble(grid.time(0), asked_.level));  // verified to go well
  Delivery elsewhere(delivered(), asked_.level);
  wake_threads([&] { static_cast<void>(formulation_->run(grid, asked_, elsewhere)); });
}

Summary FormulationCandidate::analyse() {
  measured_windows().begin();
  const Summary summary = formulation_->run(grid, asked_, delivery_);
  if (!summary.ok()) fail(describe(summary, problem().plan.model));
  return summary;
}

void FormulationCandidate::sample_afresh(double duration) {
  measure([&] {
    on_fresh_heap([&] {
      make();
      add_sample(step_seconds(duration));
      discard();
    });
  });
}

double FormulationCandidate::step_seconds(double duration) {
  Delivery delivery(delivered(), asked_.level);
  const double start = cpu_now();
  double spent = 0;
  long instants = 0;
  do {
    const Summary summary = formulation_->run(grid, asked_, delivery);
    if (!summary.ok()) throw std::runtime_error(describe(summary, problem().plan.model));
    instants += summary.instants;
    spent = cpu_now() - start;
  } while (spent < duration);
  return spent / static_cast<double>(instants);
}

double FormulationCandidate::min_seconds() const {
  return seconds().empty() ? std::numeric_limits<double>::infinity() : std::ranges::min(seconds());
}

}  // namespace desmo::bench
