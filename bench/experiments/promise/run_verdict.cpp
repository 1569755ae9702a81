#include "bench/experiments/promise/run_verdict.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

#include "bench/experiments/promise/judgeable.h"
#include "formulations/id.h"
#include "formulations/verification/assessment/limits.h"
#include "formulations/verification/error.h"
#include "formulations/verification/monitor/running_scales.h"

namespace desmo::promise {

namespace {

/// Returns the least scales of rates: what hardly moves is judged by its drivers, as monitors do.
Scales scales_of_drivers(const DrawnScene& scene) {
  const double size = nominal_size(scene.model);
  PerLevel<double> length{}, rotation{};
  for (const Driver& d : scene.model.drivers)
    for (const double t : looks_ahead(scene.scene.grid)) {
      const MotionSample<double> z = sample(d.motion, t);
      PerLevel<double>& s = is_length(scene.model.entities[d.coordinate].kind) ? length : rotation;
      s.velocity = std::max(s.velocity, std::abs(z.velocity));
      s.acceleration = std::max(s.acceleration, std::abs(z.acceleration));
    }
  Scales result;
  result.length.position = result.rotation.position = 0;
  for (const Level l : {Level::velocity, Level::acceleration}) {
    result.length[l] = VerdictLimits::min_scale * size * rotation[l];
    result.rotation[l] = VerdictLimits::min_scale * length[l] / size;
  }
  return result;
}

/// Returns the scales of the delivered instants: of the truth, or larger where a degraded instant
/// has larger numbers, since stated bounds are relative to these.
Scales scales_of(const DrawnScene& scene, const SolvedScene& solved) {
  std::vector<ReferenceInstant> truth, degraded;
  for (const Delivered& d : solved.instants) {
    const TrueInstant& t = scene.truth[d.index];
    if (has_answer(t)) truth.push_back(t.instant);
    if (d.degraded) degraded.push_back({t.instant.time, d.q, d.qd, d.qdd});
  }
  Scales scales = make_scales(scene.model, truth);
  const Scales others = make_scales(scene.model, degraded);
  const Scales drivers = scales_of_drivers(scene);
  for (const auto column : {&Scales::length, &Scales::rotation}) {
    PerLevel<double>& s = scales.*column;
    for (const Level level : all_levels)
      s[level] = std::max({s[level], (others.*column)[level], (drivers.*column)[level]});
    s.acceleration =
        std::max(s.acceleration, VerdictLimits::min_scale * s.velocity * s.velocity / s.position);
  }
  return scales;
}

/// Returns whether an instant is after a crossing that the run reports.
bool is_doubtful(const MonitoredSummary& s, double time) {
  return s.crossing && (time > s.crossing->after || time >= s.crossing->before);
}

/// Returns the errors of an instant that has an answer; of two answers the nearer one counts.
PerLevel<double> errors(const DrawnScene& scene, const Delivered& d, const Scales& scales) {
  PerLevel<double> result = errors_of(scene.model, scene.truth[d.index].instant, d, scales);
  if (d.index >= std::ssize(scene.other_answers) || scene.other_answers[d.index].q.empty())
    return result;
  const PerLevel<double> other = errors_of(scene.model, scene.other_answers[d.index], d, scales);
  for (const Level l : all_levels) result[l] = std::min(result[l], other[l]);
  return result;
}

struct Worst {
  double ratio = 1;  // error over what is allowed
  RunVerdict details;
};

void compare(Worst& worst, const PerLevel<double>& errors, const PerLevel<double>& allowed,
             const TrueInstant& truth, const char* what) {
  const PerLevel<double> floor = floor_of(truth);
  for (const Level level : all_levels) {
    const double limit = VerdictLimits::scale_slack * allowed[level] + floor[level];
    if (limit >= VerdictLimits::no_digit) continue;
    if (!(errors[level] > worst.ratio * limit)) continue;
    worst.ratio = errors[level] / limit;
    worst.details = {PromiseVerdict::wrong, what,           level, errors[level], allowed[level],
                     truth.instant.time,    truth.condition};
  }
}

/// Returns the verdict about a run's wrong numbers; nothing when there is none.
std::optional<RunVerdict> find_wrong(const DrawnScene& scene, const SolvedScene& solved) {
  const Scales scales = scales_of(scene, solved);
  const PerLevel<double> limit = Limits(solved.tolerance).degraded;
  const bool failed = solved.summary.outcome() == Outcome::failed;
  Worst promise, bound;
  const int decided = decided_until(scene, solved.is_single);
  for (const Delivered& d : solved.instants) {
    const TrueInstant& truth = scene.truth[d.index];
    if (is_doubtful(solved.summary, truth.instant.time) || d.index >= decided) continue;
    if (!has_answer(truth)) {
      if (d.degraded || scene.overconstrained) continue;
      return RunVerdict{PromiseVerdict::wrong, "no answer",    Level::position, INFINITY, 0,
                        truth.instant.time,    truth.condition};
    }
    const PerLevel<double> off = errors(scene, d, scales);
    if (!d.degraded) compare(promise, off, limit, truth, "promise");
    if (failed) continue;  // no bound is stated
    compare(bound, off, solved.summary.bound, truth, d.degraded ? "bound, degraded" : "bound");
  }
  if (promise.ratio > 1) return promise.details;
  if (bound.ratio > 1) return bound.details;
  return std::nullopt;
}

/// Returns whether all numbers are within the limits, whatever is said of them.
bool all_right(const DrawnScene& scene, const SolvedScene& solved) {
  const Scales scales = scales_of(scene, solved);
  const PerLevel<double> limit = Limits(solved.tolerance).degraded;
  return std::ranges::all_of(solved.instants, [&](const Delivered& d) {
    const TrueInstant& truth = scene.truth[d.index];
    return has_answer(truth) && !exceeds(errors(scene, d, scales), limit);
  });
}

/// Returns the index of the instant nearest to a time [s].
int index_of(const TimeGrid& grid, double time) {
  const double i = std::nearbyint((time - grid.start) / grid.interval());
  return static_cast<int>(std::clamp(i, 0.0, grid.instants - 1.0));
}

RunVerdict verdict_on_failure(const DrawnScene& scene, const MonitoredSummary& s) {
  const int at = static_cast<int>(s.instants);
  const bool is_false = is_regular(scene, at - 1, at) && !is_doubtful(s, s.time);
  RunVerdict verdict{is_false ? PromiseVerdict::false_failure : PromiseVerdict::flagged};
  verdict.what = s.violated >= 0                     ? "another branch"
                 : s.status == Status::singular      ? "singular"
                 : s.status == Status::not_converged ? "not converged"
                                                     : "not finite";
  verdict.time = s.time;
  if (at < std::ssize(scene.truth)) verdict.condition = scene.truth[at].condition;
  return verdict;
}

/// A crossing is reported falsely where all is right without the report, too.
RunVerdict verdict_on_crossing(const DrawnScene& scene, const SolvedScene& solved) {
  static constexpr const char* kinds[] = {"passed", "jumped", "not declared"};
  const SingularityCrossing& crossing = *solved.summary.crossing;
  const TimeGrid& grid = scene.scene.grid;
  const int from = index_of(grid, crossing.after), to = index_of(grid, crossing.before);
  RunVerdict verdict{PromiseVerdict::flagged, kinds[static_cast<int>(crossing.kind)]};
  verdict.time = crossing.before;
  verdict.condition = scene.truth[to].condition;
  SolvedScene unflagged = solved;
  unflagged.summary.crossing.reset();
  if (is_regular(scene, from - 1, to + 1) && all_right(scene, solved) &&
      !find_wrong(scene, unflagged))
    verdict.verdict = PromiseVerdict::false_flag;
  return verdict;
}

RunVerdict verdict_on_degradation(const DrawnScene& scene, const SolvedScene& solved) {
  const Degradation& first = *solved.summary.first_degraded;
  const PerLevel<double>& stated = first.assessment.bound;
  const PerLevel<double> limit = Limits(solved.tolerance).degraded;
  const int at = index_of(scene.scene.grid, first.time);
  const TrueInstant& truth = scene.truth[at];
  RunVerdict verdict{PromiseVerdict::flagged, "degraded"};
  verdict.level = *std::ranges::max_element(
      all_levels, {}, [&](Level level) { return stated[level] / limit[level]; });
  verdict.allowed = stated[verdict.level];
  verdict.time = first.time;
  verdict.condition = truth.condition;
  const auto d = std::ranges::find(solved.instants, at, &Delivered::index);
  if (d != solved.instants.end() && has_answer(truth))
    verdict.error =
        errors_of(scene.model, truth.instant, *d, scales_of(scene, solved))[verdict.level];
  if (is_regular(scene, at, at) && all_right(scene, solved))
    verdict.verdict = PromiseVerdict::false_flag;
  return verdict;
}

/// Returns the verdict about the flag of a run without wrong numbers.
RunVerdict verdict_on_flag(const DrawnScene& scene, const SolvedScene& solved) {
  const MonitoredSummary& s = solved.summary;
  if (s.outcome() == Outcome::converged) return {};
  if (s.outcome() == Outcome::failed) return verdict_on_failure(scene, s);
  return s.crossing ? verdict_on_crossing(scene, solved) : verdict_on_degradation(scene, solved);
}

class Collector final : public Observer {
 public:
  explicit Collector(SolvedScene& solved) : solved_(solved) {}
  Flow observe(const Instant& i) noexcept override {
    solved_.instants.push_back({i.index,
                                degraded,
                                {i.q.begin(), i.q.end()},
                                {i.qd.begin(), i.qd.end()},
                                {i.qdd.begin(), i.qdd.end()}});
    return Flow::go_on;
  }
  bool degraded = false;  // the next instant

 private:
  SolvedScene& solved_;
};

}  // namespace

PerLevel<double> errors_of(const Model& m, const ReferenceInstant& truth, const Delivered& d,
                           const Scales& scales) {
  ErrorMeasure measure(m, {&truth, 1}, scales);
  measure.observe({0, truth.time, d.q, d.qd, d.qdd});
  const SolutionError e = measure.error();
  return {e.position.max, e.velocity.max, e.acceleration.max};
}

RunVerdict verdict_on_run(const DrawnScene& scene, const SolvedScene& solved) {
  if (std::optional<RunVerdict> wrong = find_wrong(scene, solved)) {
    if (solved.summary.outcome() == Outcome::failed) wrong->what += ", then failed";
    return *wrong;
  }
  return verdict_on_flag(scene, solved);
}

RunVerdict verdict_on_id(const DrawnScene& scene, const std::string& id) {
  std::unique_ptr<Formulation> f;
  std::optional<Configuration> c;
  try {
    c = parse_id(id, {.tolerance = scene.scene.tolerance});
    f = make_formulation(*c->variant, scene.model, c->settings);
  } catch (const std::invalid_argument& error) {
    return {PromiseVerdict::not_applicable, error.what()};
  }
  SolvedScene solved{{}, {}, c->settings.tolerance, c->settings.scalar == Scalar::single_precision};
  Collector collector(solved);
  MonitoredRunOptions options;
  options.monitored = [&](const MonitoredInstant& m) { collector.degraded = m.degraded; };
  solved.summary = run_monitored(*f, scene.scene.grid, {}, collector, options);
  // What the motion's scales excuse in the end is no flag.
  if (solved.summary.degraded == 0)
    for (Delivered& d : solved.instants) d.degraded = false;
  return verdict_on_run(scene, solved);
}

}  // namespace desmo::promise
