#include "bench/kit/formulation_candidate.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "bench/kit/candidate_name.h"
#include "bench/kit/digests.h"
#include "bench/kit/memory.h"
#include "formulations/variants.h"

namespace desmo::bench {

FormulationCandidate::FormulationCandidate(const Problem& problem, const Configuration& c)
    : FormulationCandidate(problem, id_with(*c.variant, c.settings), c) {}

FormulationCandidate::FormulationCandidate(const Problem& problem, std::string_view id,
                                           const Settings& others)
    : FormulationCandidate(problem, id, parse_id(id, others)) {}

FormulationCandidate::FormulationCandidate(const Problem& problem, std::string_view id,
                                           const Configuration& c, Clock by)
    : Candidate(problem.grid, c.settings.threads, by),
      request_{problem.level(), problem.delivered},
      problem_(problem),
      id_(id),
      configuration_(c) {}

std::string FormulationCandidate::id() const {
  return id_ + (clock() == Clock::wall && threads() == 1 ? "/clock:wall" : "");
}

std::string FormulationCandidate::name() const {
  return CandidateName{case_name(), coordinates(), id()}.text();
}

const std::string& FormulationCandidate::case_name() const {
  return problem_.case_name.empty() ? problem_.plan.model.name : problem_.case_name;
}

int FormulationCandidate::coordinates() const {
  return problem_.whole ? problem_.whole->coordinates() : static_cast<int>(delivered());
}

std::size_t FormulationCandidate::delivered() const {
  return request_.coordinates.empty() ? problem_.plan.model.coordinates()
                                      : request_.coordinates.size();
}

std::unique_ptr<Formulation> FormulationCandidate::make_formulation() const {
  const Plan& plan = problem_.plan;
  auto formulation = desmo::make_formulation(variant(), plan.model, settings(), problem_.kernels);
  if (!plan.levels.empty()) formulation->solve_only(plan.levels);
  return formulation;
}

Summary FormulationCandidate::run(Formulation& formulation, Observer& observer) const {
  return formulation.run(grid(), request_, observer);
}

FormulationCandidate::Checked FormulationCandidate::check(VerifyingRun& found) {
  const Model& model = problem_.plan.model;
  const Model& whole = problem_.whole ? *problem_.whole : model;
  found.model = model_digest(whole);
  found.level = request_.level;
  if (std::string reason = unavailable_reason(settings()); !reason.empty())
    return not_run(std::move(reason));
  if (problem_.missing)
    if (std::string reason = problem_.missing(configuration_); !reason.empty())
      return not_run(std::move(reason));
  const std::size_t bytes_before = heap_in_use();
  const double before_setup = cpu_now();
  const auto formulation = make_formulation();
  found.setup_seconds = cpu_now() - before_setup;
  found.bytes = static_cast<long>(heap_in_use() - bytes_before);
  if (std::string missing = missing_code(*formulation); !missing.empty())
    return failed(std::move(missing));

  const std::span<const ReferenceInstant> own = problem_.reference.instants;
  const auto right = own.empty() ? shared_reference(whole, grid(), settings().stride) : own;
  ComparingObserver observer(delivered(), request_.level, right, compared(right));
  const double start = now(clock());
  const Summary summary = run(*formulation, observer);
  found.analysis_seconds = now(clock()) - start;
  const Comparison comparison = observer.compare();
  found.errors = comparison.errors;
  found.results = comparison.results;
  if (!summary.ok()) return failed(describe(summary, model));
  found.iterations_per_step = static_cast<double>(summary.iterations) / summary.instants;
  found.residual = summary.residual;
  std::string wrong = verification_failure(
      found.errors, right.size(), std::max(1.0, problem_.tolerance / Settings{}.tolerance));
  if (wrong.empty()) return {};
  return failed(std::move(wrong));
}

std::vector<Compared> FormulationCandidate::compared(
    std::span<const ReferenceInstant> reference) const {
  if (!problem_.compared.empty()) return problem_.compared;
  PerLevel<std::vector<double>> scales;
  if (problem_.is_relative) scales = coordinate_scales(problem_.plan.model, reference);
  return all_compared(delivered(), request_.level, scales);
}

/// Makes a formulation and assembles the mechanism. Where the wall clock measures, also runs the
/// motion until all threads and their processors are awake. Waking them may take as long as a
/// motion, and longer on virtual machines. One thread that is compared with several is treated
/// alike.
std::unique_ptr<Formulation> FormulationCandidate::make_assembled() const {
  auto formulation = make_formulation();
  static_cast<void>(formulation->assemble(grid().time(0), request_.level));  // check() saw success
  Delivery elsewhere(delivered(), request_.level);
  const double begin = now(clock());
  while (clock() == Clock::wall && now(clock()) - begin < min_wall_seconds)
    static_cast<void>(run(*formulation, elsewhere));
  return formulation;
}

Analysis FormulationCandidate::make_analysis(TimingWindows& windows) const {
  const std::shared_ptr<Formulation> formulation = make_assembled();
  const auto delivery = std::make_shared<WindowedDelivery>(delivered(), request_.level, windows);
  return [this, formulation, delivery, &windows] {
    windows.begin();
    const Summary summary = run(*formulation, *delivery);
    if (!summary.ok()) throw std::runtime_error(describe(summary, formulation->model()));
  };
}

void FormulationCandidate::sample_afresh(double duration) {
  measure(
      [&] { run_on_fresh_heap([&] { add_sample(step_seconds(*make_assembled(), duration)); }); });
}

double FormulationCandidate::step_seconds(Formulation& formulation, double duration) const {
  Delivery delivery(delivered(), request_.level);
  const double start = now(clock());
  double spent = 0;
  long instants = 0;
  do {
    const Summary summary = run(formulation, delivery);
    if (!summary.ok()) throw std::runtime_error(describe(summary, formulation.model()));
    instants += summary.instants;
    spent = now(clock()) - start;
  } while (spent < duration);
  return spent / static_cast<double>(instants);
}

double FormulationCandidate::min_seconds() const {
  return is_timed() ? std::ranges::min(seconds()) : std::numeric_limits<double>::infinity();
}

bool FormulationCandidate::has_enough_samples(double long_motion_seconds) const {
  return seconds().size() >= 2 && min_seconds() * grid().instants > long_motion_seconds;
}

}  // namespace desmo::bench
