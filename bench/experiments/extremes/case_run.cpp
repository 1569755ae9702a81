#include "bench/experiments/extremes/case_run.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <stdexcept>
#include <utility>

#include "bench/kit/memory.h"
#include "bench/kit/variant_costs.h"
#include "bench/kit/verification.h"
#include "cases/mechanism/formatted.h"
#include "formulations/model/partition.h"
#include "formulations/motion/internals.h"
#include "formulations/verification/error.h"
#include "formulations/verification/run/relative_radius.h"

namespace desmo::extremes {

namespace {

constexpr int max_dense = 400;  // coordinates of dense global solves (≤): O(n³) a step
// Limits (≤) for formulations that are not is_fast(); max_instants is for other algebra than eigen.
constexpr int max_coordinates = 5'000;
constexpr long max_instants = 100'000;
/// Coordinates of formulations by blocks (≤). Every part keeps a workspace of some kilobytes, and
/// there are more blocks than groups.
constexpr int max_in_blocks = 1'000'000;

/// Returns whether a formulation is generated, or solves all unknowns by a single call of KLU.
bool is_fast(const Variant& v) {
  return v.is_generated() || (v.partition == Partition::global && v.algebra == "klu");
}

/// Returns why a formulation is not tried on a case that has a model, in a sentence without a full
/// stop; empty: it is tried.
std::string unsupported(const Configuration& configuration, const KnownCase& known) {
  const Variant& v = *configuration.variant;
  if (std::string why = unsupported_reason(v, configuration.settings); !why.empty()) return why;
  const int coordinates = known.modelled->model.coordinates();
  if (bench::is_dense_global(v) && coordinates > max_dense)
    return "dense matrices of all unknowns: a step costs O(n³)";
  if (v.partition == Partition::block && coordinates > max_in_blocks)
    return "workspaces of so many blocks take too much memory";
  if (is_fast(v)) return {};
  if (coordinates > max_coordinates) return "it takes too long with so many coordinates";
  if (v.algebra != "eigen" && static_cast<long>(known.solvable.size()) > max_instants)
    return "it takes too long with so many instants";
  return {};
}

/// Removes the whole turns by which angles of q differ from those of `right`.
void turn_back(const Model& m, std::span<const double> right, std::vector<double>& q) {
  constexpr double turn = 2 * std::numbers::pi;
  for (const Entity& e : m.entities)
    if (e.kind == EntityKind::angle && !e.fixed)
      q[e.first] -= turn * std::nearbyint((q[e.first] - right[e.first]) / turn);
}

/// Returns the relative errors of an instant. Whole turns of angles are no errors where an estimate
/// alone says which turn is meant: from a start, and after a gap.
/// - of: index in KnownCase::answers
/// - next: index in KnownCase::compared; the answer there must be known
PerLevel<double> error_of(const Instant& instant, const KnownCase& known, std::size_t of,
                          std::size_t next) {
  const Answers& answers = known.answers[of];
  const ReferenceInstant& right = answers.right[next];
  const auto part = [&](std::span<const double> whole) {
    std::vector<double> values;
    for (const int i : answers.coordinate) values.push_back(whole[i]);
    return values;
  };
  std::vector<double> q = part(instant.q);
  if (const ExtremeCase& c = *known.definition; c.starts || c.past_failures)
    turn_back(answers.model, right.q, q);
  const std::vector<double> qd = part(instant.qd), qdd = part(instant.qdd);
  ErrorMeasure measure(answers.model, {&right, 1}, answers.scales);
  measure.observe({0, right.time, q, qd, qdd});
  const SolutionError e = measure.error();
  return {e.position.max, e.velocity.max, e.acceleration.max};
}

/// Number of instants after which a run should have allocated all the memory that it needs.
constexpr std::size_t early = 1000;

/// An observer that notes the result of each instant, or start, in a CaseRun.
class CaseObserver final : public Observer {
 public:
  CaseObserver(const KnownCase& known, const Formulation& formulation, CaseRun& run)
      : case_(known), model_(formulation.model()), run_(run) {
    for (const DefinedPart& part : parts_of(formulation))
      if (!part.definition.constant) unknowns_ += std::ssize(part.definition.unknowns);
    for (const Answers& answers : known.answers) run.errors.emplace_back(answers.right.size());
    run.stated.resize(known.compared.size());
    // Memory that this vector took later would count as the formulation's.
    run.steps.reserve(known.solvable.size());
  }

  /// Sets the index of the instant, or start, with which the next run begins.
  void begin(std::size_t first) { first_ = first; }

  void note(const CheckedInstant& row) {
    using Kind = RowFlag::Kind;
    flag_ = !row.flag ? CaseRun::Flag::none
            : row.flag->kind == Kind::unproven || row.flag->kind == Kind::misfit
                ? CaseRun::Flag::unproven
                : CaseRun::Flag::other_branch;
    stated_ = {row.condition, row.relative_radius};
    if (case_.answers.empty()) return;
    // Divides the radii by the scales of errors. The run's own scales come from other instants.
    const PerLevel<double> radius =
        relative_radius(model_, row.radius, case_.answers.front().scales).largest;
    for (const Level level : all_levels)
      if (std::isfinite(stated_.radius[level]) && radius[level] > 0)
        stated_.radius[level] = radius[level];
  }

  Flow observe(const Instant& instant) noexcept override {
    const std::size_t i = first_ + instant.index;
    weigh(i);
    run_.steps.resize(i, {CaseRun::Flag::failed});  // instants of a gap
    run_.steps.push_back({flag_, unknowns_ > 0 ? static_cast<double>(instant.updates) /
                                                     static_cast<double>(unknowns_)
                                               : 0});
    const auto& compared = case_.compared;
    const auto found = std::ranges::lower_bound(compared, static_cast<int>(i));
    if (found == compared.end() || *found != static_cast<int>(i)) return Flow::go_on;
    const std::size_t next = found - compared.begin();
    for (std::size_t k = 0; k < case_.answers.size(); ++k)
      if (!case_.answers[k].right[next].q.empty())
        run_.errors[k][next] = error_of(instant, case_, k, next);
    run_.stated[next] = stated_;
    return Flow::go_on;
  }

  /// Notes the end of a run. grid: the instants that it was to solve.
  void end(const CheckedSummary& summary, const TimeGrid& grid, const Model& m) {
    const std::size_t last = first_ + grid.instants;
    auto& steps = run_.steps;
    if (steps.size() < last) {
      const bool went_on = !summary.gaps.empty();
      steps.resize(went_on ? last : steps.size() + 1, {CaseRun::Flag::failed});
    }
    run_.max.condition = std::max(run_.max.condition, summary.condition);
    for (const Level l : all_levels)
      run_.max.radius[l] = std::max(run_.max.radius[l], summary.radius[l]);
    run_.gaps.insert(run_.gaps.end(), summary.gaps.begin(), summary.gaps.end());
    note_flag(summary, m);
  }

 private:
  void weigh(std::size_t instant) {
    const bool is_first = instant >= early && early_heap_ == 0;
    if (is_first) early_heap_ = bench::heap_in_use();
    if (!is_first && early_heap_ > 0 && instant + 1 == case_.solvable.size())
      run_.heap_growth =
          static_cast<std::int64_t>(bench::heap_in_use()) - static_cast<std::int64_t>(early_heap_);
  }

  void note_flag(const CheckedSummary& s, const Model& m) {
    if (!run_.message.empty() || s.outcome() == desmo::Outcome::converged) return;
    const Summary failure = s.gaps.empty() ? Summary{s} : s.gaps.front().failure;
    run_.failed_group = failure.group;
    run_.message = !failure.ok() ? desmo::describe(failure, m) : describe(*s.first_flag);
  }

  static std::string describe(const RowFlag& flag) {
    return formatted("%s from t = %.9g s on", std::string(word_of(flag)).c_str(), flag.time);
  }

  const KnownCase& case_;
  const Model& model_;
  CaseRun& run_;
  std::size_t first_ = 0, early_heap_ = 0;
  long unknowns_ = 0;
  CaseRun::Flag flag_ = CaseRun::Flag::none;
  CaseRun::Stated stated_{};
};

}  // namespace

CaseOutcome CaseRun::outcome() const {
  if (unsolved) return *unsolved;
  Flag worst = Flag::none;
  for (const Step& step : steps) worst = std::max(worst, step.flag);
  return worst == Flag::failed ? CaseOutcome::failed
         : worst == Flag::none ? CaseOutcome::converged
                               : CaseOutcome::degraded;
}

CaseRun run_case(const KnownCase& known, const Configuration& configuration) {
  CaseRun run;
  const auto stop = [&](CaseOutcome outcome, std::string why) {
    run.unsolved = outcome;
    run.message = std::move(why);
    return run;
  };
  if (!known.modelled) return stop(CaseOutcome::refused, known.refusal);
  if (std::string why = unsupported(configuration, known); !why.empty())
    return stop(CaseOutcome::not_applicable, std::move(why));

  const ExtremeCase& definition = *known.definition;
  std::optional<Model> started;  // its estimate changes from start to start
  if (definition.starts) started = known.modelled->model;
  const Model& m = started ? *started : known.modelled->model;
  std::unique_ptr<Formulation> f;
  try {
    f = make_formulation(*configuration.variant, m, configuration.settings);
  } catch (const std::invalid_argument& error) {
    return stop(CaseOutcome::refused, error.what());
  }
  if (std::string why = bench::missing_code(*f); !why.empty())
    return stop(CaseOutcome::not_applicable, std::move(why));

  CaseObserver observer(known, *f, run);
  CheckOptions options;
  options.past_failures = definition.past_failures;
  options.checked = [&](const CheckedInstant& row) { observer.note(row); };
  const std::size_t runs = definition.starts ? known.starts.size() : 1;
  const TimeGrid grid = definition.starts
                            ? TimeGrid{definition.scene.grid.start, definition.scene.grid.step, 1}
                            : definition.scene.grid;
  for (std::size_t i = 0; i < runs; ++i) {
    if (started) started->estimate = known.starts[i];
    observer.begin(i);
    observer.end(run_checked(*f, grid, {}, observer, options), grid, m);
  }
  return run;
}

}  // namespace desmo::extremes
