#include "bench/experiments/extremes/candidate.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <utility>

#include "bench/experiments/extremes/applicability.h"
#include "bench/experiments/extremes/comparison.h"
#include "bench/kit/memory/heap.h"

namespace desmo::extremes {

namespace {

/// Instants after which a run has all the memory that it needs.
constexpr std::size_t early = 1000;

/// Keeps what becomes of each instant, or start.
class Record final : public Observer {
 public:
  Record(const Problem& problem, const Formulation& formulation, Attempt& attempt)
      : problem_(problem), attempt_(attempt) {
    for (const DefinedPart& part : formulation.parts())
      if (!part.definition.constant) unknowns_ += std::ssize(part.definition.unknowns);
    for (const Answers& answers : problem.answers)
      attempt.errors.emplace_back(answers.right.size());
    attempt.stated.resize(problem.compared.size());
    attempt.steps.reserve(problem.solvable.size());  // so that nothing here grows
  }

  /// The runs to come begin with that instant, or start.
  void begin(std::size_t first) { first_ = first; }

  void judged(const Watch::Judgement& judgement) {
    degraded_ = judgement.degraded;
    stated_ = {judgement.assessment.condition, judgement.assessment.bound};
  }

  void observe(const Instant& instant) override {
    const std::size_t i = first_ + instant.index;
    weigh(i);
    attempt_.steps.resize(i, {Attempt::Flag::failed});  // those that were passed over
    attempt_.steps.push_back(
        {degraded_ ? Attempt::Flag::degraded : Attempt::Flag::none,
         unknowns_ > 0 ? static_cast<double>(instant.updates) / static_cast<double>(unknowns_)
                       : 0});
    const auto& compared = problem_.compared;
    const auto found = std::ranges::lower_bound(compared, static_cast<int>(i));
    if (found == compared.end() || *found != static_cast<int>(i)) return;
    const std::size_t next = found - compared.begin();
    for (std::size_t k = 0; k < problem_.answers.size(); ++k)
      if (!problem_.answers[k].right[next].q.empty())
        attempt_.errors[k][next] = error_of(instant, problem_, k, next);
    attempt_.stated[next] = stated_;
  }

  /// A run is over that was to last so many instants.
  void end(const SafeSummary& summary, const TimeGrid& grid, const Model& m) {
    const std::size_t last = first_ + grid.instants;
    auto& steps = attempt_.steps;
    if (steps.size() < last) {
      const bool went_on = !summary.gaps.empty();
      steps.resize(went_on ? last : steps.size() + 1, {Attempt::Flag::failed});
    }
    if (summary.crossing)
      for (std::size_t i = first_; i < steps.size(); ++i)
        if (const double t = grid.time(static_cast<int>(i - first_));
            steps[i].flag != Attempt::Flag::failed &&
            (t > summary.crossing->after || t >= summary.crossing->before))
          steps[i].flag = Attempt::Flag::doubtful;
    attempt_.iterations += summary.iterations;
    attempt_.most.condition = std::max(attempt_.most.condition, summary.condition);
    for (const Level l : levels)
      attempt_.most.bound[l] = std::max(attempt_.most.bound[l], summary.bound[l]);
    attempt_.gaps.insert(attempt_.gaps.end(), summary.gaps.begin(), summary.gaps.end());
    note_flag(summary, m);
  }

 private:
  void weigh(std::size_t instant) {
    const bool is_first = instant >= early && early_heap_ == 0;
    if (is_first) early_heap_ = bench::heap_in_use();
    if (!is_first && early_heap_ > 0 && instant + 1 == problem_.solvable.size())
      attempt_.heap_growth =
          static_cast<std::int64_t>(bench::heap_in_use()) - static_cast<std::int64_t>(early_heap_);
  }

  void note_flag(const SafeSummary& s, const Model& m) {
    if (!attempt_.message.empty() || s.outcome() == desmo::Outcome::converged) return;
    const Summary& failure = s.gaps.empty() ? s : s.gaps.front().failure;
    attempt_.failed_group = failure.group;
    attempt_.message = !failure.ok() ? desmo::describe(failure, m)
                       : s.crossing  ? describe(*s.crossing)
                                     : describe(*s.first_degraded);
  }

  static std::string describe(const Crossing& c) {
    static constexpr const char* what[] = {"passes a singular position", "jumps",
                                           "not assembled as declared"};
    char text[120];
    std::snprintf(text, sizeof text, "%s between t = %.9g s and %.9g s",
                  what[static_cast<int>(c.kind)], c.after, c.before);
    return text;
  }
  static std::string describe(const Degradation& d) {
    char text[60];
    std::snprintf(text, sizeof text, "degraded from t = %.9g s on: ", d.time);
    return text +
           describe_accuracy(d.assessment.condition, d.assessment.bound, Level::acceleration);
  }

  const Problem& problem_;
  Attempt& attempt_;
  std::size_t first_ = 0, early_heap_ = 0;
  long unknowns_ = 0;
  bool degraded_ = false;
  Attempt::Stated stated_{};
};

}  // namespace

Attempt attempt(const Problem& problem, const Configuration& configuration, unsigned without) {
  Attempt a;
  const auto stop = [&](Attempt::Ending ending, std::string why) {
    a.ending = ending;
    a.message = std::move(why);
    return a;
  };
  if (!problem.modelled) return stop(Attempt::Ending::refused, problem.refusal);
  if (std::string why = why_not_tried(configuration, problem); !why.empty())
    return stop(Attempt::Ending::not_applicable, std::move(why));

  const ExtremeCase& c = *problem.definition;
  std::optional<Model> started;  // its estimate changes from start to start
  if (c.starts) started = problem.modelled->model;
  const Model& m = started ? *started : problem.modelled->model;
  std::unique_ptr<Formulation> f;
  try {
    f = make_formulation(*configuration.variant, m, configuration.settings);
  } catch (const std::invalid_argument& error) {
    return stop(Attempt::Ending::refused, error.what());
  }
  if (std::string why = lacks_generated_code(*f); !why.empty())
    return stop(Attempt::Ending::not_applicable, std::move(why));

  Record record(problem, *f, a);
  SafetyOptions options;
  options.tolerance = configuration.settings.tolerance;
  options.without = without;
  options.past_failures = c.goes_on;
  options.judged = [&](const Watch::Judgement& j) { record.judged(j); };
  const std::size_t runs = c.starts ? problem.starts.size() : 1;
  const TimeGrid grid =
      c.starts ? TimeGrid{c.scene.grid.start, c.scene.grid.step, 1} : c.scene.grid;
  for (std::size_t i = 0; i < runs; ++i) {
    if (started) started->estimate = problem.starts[i];
    record.begin(i);
    record.end(run_safely(*f, grid, {}, record, options), grid, m);
  }
  a.refactorisations = f->refactorisations();
  return a;
}

}  // namespace desmo::extremes
