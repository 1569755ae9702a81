#include "formulations/verification/monitor/accuracy_monitor.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "formulations/algebra/linear_solver.h"
#include "formulations/verification/assessment/assessor.h"
#include "formulations/verification/assessment/backward_error.h"
#include "formulations/verification/assessment/expectation.h"
#include "formulations/verification/assessment/limits.h"
#include "formulations/verification/assessment/measured_error.h"
#include "formulations/verification/condition.h"
#include "formulations/verification/monitor/branch_signs.h"
#include "formulations/verification/monitor/condition_monitor.h"
#include "formulations/verification/monitor/continuity.h"
#include "formulations/verification/monitor/degradations.h"
#include "formulations/verification/monitor/running_scales.h"
#include "formulations/verification/monitor/sensitivity_monitor.h"

namespace desmo {

namespace {

/// By how much the gain may grow before an instant is assessed.
constexpr double factor = 4;
/// Instants from one look at the scales to the next: they grow slowly, and small ones are safe.
constexpr int look_every = 16;
/// Bounds of rates above which it cannot be told whether they lead on.
constexpr double noise = 1e-3;
/// By how much pivots may shrink before residuals of rates are looked at.
constexpr double shrunk = 20;
/// What residuals show of errors at an estimated condition number, times this, bounds them.
constexpr double shown_by = 10;

}  // namespace

struct AccuracyMonitor::State {
  const Model& model;
  const AccuracyMonitorOptions options;
  const Limits limits;
  Assessor assessor;
  std::vector<Level> asked;  // of each coordinate
  MeasuredError measured;
  RunningScales scales;
  SensitivityMonitor sensitivity;
  ConditionMonitor conditioning;
  Continuity continuity;
  BackwardError backward_error;
  Expectation expectation{};
  BranchSigns signs;
  std::vector<EntityId> entity;  // of each coordinate
  Eigen::ArrayXd weights;        // the largest so far: near a dead point they say little
  Start beyond{};                // a singular position, where the last instant lies in one

  Assessment last{};  // that was made
  double last_time = 0;
  bool started = false, degraded = false;
  bool after_gap = false, is_doubted = false;
  bool is_lost = false;  // no short steps lead to the instant, which was interpolated
  int since = 0;         // instants since the last assessment
  double condition = 0;
  PerLevel<double> worst{};
  Degradations degradations;
  long assessed = 0, corrected = 0;

  State(const Model& m, const TimeGrid& grid, const AccuracyMonitorOptions& o)
      : model(m),
        options(o),
        limits(o.tolerance),
        assessor(m, o.levels, o.asked),
        asked(o.asked.empty() ? assessor.levels().begin() : o.asked.begin(),
              o.asked.empty() ? assessor.levels().end() : o.asked.end()),
        measured(m, assessor.system(), assessor.levels(), asked),
        scales(m, grid, o.scales),
        sensitivity(m, assessor.levels(), assessor.system().magnitudes()),
        conditioning(m, assessor.system()),
        continuity(m, grid, assessor.system().magnitudes(), o.max_steps),
        backward_error(m, assessor.levels()),
        signs(m, assessor.system()),
        entity(entity_of_coordinate(m)),
        degradations(limits.degraded, o.max_degradations) {}

  bool has(Monitor monitor) const { return !(options.without & static_cast<unsigned>(monitor)); }

  MonitoredInstant examine(const Instant& instant) {
    MonitoredInstant j{instant};
    const Expectation::Signals signals = signals_of(instant);
    const Assessment expected = expectation(signals);
    const Statement statement = state(instant, expected);
    const bool in_doubt = is_in_doubt(instant, signals);
    j.angles_follow = !in_doubt && has(Monitor::continuity) && continuity.angles_follow();
    std::optional<Continuity::Jump> jump;
    is_lost = false;
    const bool known_before = rates_are_known(), from_noise = degraded && !known_before;
    if (in_doubt && !instant.interpolated) jump = find_jump(j, from_noise);
    // A doubt remains one even where shorter steps agree: next to where solutions meet, they too
    // may end on another branch.
    const bool is_assessed = in_doubt || !statement.holds || is_due(signals);
    if (is_assessed)
      assess(j, signals, statement.assessment);
    else
      j.assessment = statement.assessment;
    if (in_doubt && instant.interpolated && !j.solved_anew) {
      jump = find_jump(j, from_noise);
      if (j.solved_anew) assess(j, signals, j.assessment);
    }
    // Nobody can tell where a doubtful step from rates that are noise leads.
    if (jump && (jump->at_turn || from_noise || (known_before && rates_are_known())))
      j.crossing = jump->crossing;
    else if ((from_noise || is_lost) && continuity.is_known() && !j.crossing)
      j.crossing = {continuity.recent()[0].time, instant.time, last.group,
                    SingularityCrossing::Kind::jumped};
    if (j.assessment.singular) return j;  // which is not delivered
    if (++since % look_every == 0 && !is_assessed) look_at_scales(j.instant);
    deliver(j, is_assessed);
    return j;
  }

  /// Counts an instant that is delivered, and keeps it to go on from.
  void deliver(const MonitoredInstant& j, bool is_assessed) {
    continuity.take(j.instant, is_assessed, j.assessment.bound);
    beyond = {};
    condition = std::max(condition, j.assessment.condition);
    add({j.instant.index, j.instant.time, j.assessment}, j.degraded);
  }

  void add(const Degradation& d, bool is_degraded) {
    for (const Level l : levels) worst[l] = std::max(worst[l], d.assessment.bound[l]);
    if (is_degraded) degradations.add(d);
  }

  void look_back(const Instant& like) {
    RecentInstants& recent = continuity.recent();
    for (int back = 0; back < recent.count() && !recent[back].is_assessed; ++back) {
      RecentInstants::Node& node = recent[back];
      Assessment a = assessor(view_of(node, like), scales.now());
      ++assessed;
      node.is_assessed = true;
      if (!exceeds(a.bound, node.stated)) return;
      measure(a, view_of(node, like));
      node.stated = a.bound;
      condition = std::max(condition, a.condition);
      add({node.index, node.time, a}, exceeds(a.bound, limits.degraded));
    }
  }

  std::optional<MonitoredInstant> solve(const Instant& instant) {
    const auto solved = continuity.is_known() ? solve_from_last(instant) : solve_alone(instant);
    if (!solved) return {};
    MonitoredInstant j{*solved};
    j.solved_anew = true;
    assess(j, signals_of(j.instant), {});
    if (j.assessment.singular) return {};
    deliver(j, true);
    ++corrected;
    return j;
  }

  std::optional<Instant> solve_from_last(const Instant& instant) {
    continuity.expect(instant);
    return continuity.solve_anew(instant, means());
  }

  /// Corrects positions that have hardly missed their tolerance, as in single precision.
  std::optional<Instant> solve_alone(const Instant& instant) {
    const Instant solved = assessor.corrected(continuity.driven(instant));
    const Assessment a = assessor(solved, scales.with(solved));
    if (a.singular || exceeds(a.bound, limits.degraded)) return {};
    return solved;
  }

  std::optional<MonitoredInstant> pass(const Instant& singular) {
    const auto p = continuity.pass(singular, means());
    if (!p) return {};
    MonitoredInstant j{p->instant};
    j.degraded = j.solved_anew = true;
    j.assessment = p->assessment;
    j.assessment.limit = Limit::singular_position;
    j.assessment.bound = difference(p->instant, p->wide);
    j.crossing = {p->after, p->before, last.group, SingularityCrossing::Kind::passed};
    deliver(j, true);
    degraded = true;  // so the next is assessed
    beyond = {p->beyond, p->before};
    ++corrected;
    return j;
  }

  /// The largest difference of two instants over outputs, relative to the scales.
  PerLevel<double> difference(const Instant& a, const Instant& b) const {
    PerLevel<double> result{};
    const auto add = [&](Level level, std::span<const double> x, std::span<const double> y) {
      for (std::size_t i = 0; i < x.size(); ++i) {
        const double scale = scales.now().of(model.entities[entity[i]].kind, level);
        if (asked[i] >= level && scale > 0)
          result[level] = std::max(result[level], std::abs(x[i] - y[i]) / scale);
      }
    };
    add(Level::position, a.q, b.q);
    add(Level::velocity, a.qd, b.qd);
    add(Level::acceleration, a.qdd, b.qdd);
    return result;
  }

  /// What is said of an instant that is not assessed, and whether it may be said.
  struct Statement {
    Assessment assessment;
    bool holds;
  };
  Statement state(const Instant& instant, const Assessment& expected) {
    Statement s{expected, true};
    if (!has(Monitor::bounds) || !started) return s;
    PerLevel<double>& bound = s.assessment.bound;
    if (instant.interpolated || has_bad_pivots()) {
      const PerLevel<double> shown =
          backward_error(instant, assessor.system(), scales.now(), expected.condition);
      if (instant.interpolated) bound.position += shown_by * shown.position;
      // Of solved positions the residual tells, with what they make of rates.
      double before = instant.interpolated ? bound.position : 0;
      for (const Level l : {Level::velocity, Level::acceleration}) {
        before = shown_by * shown[l] + expected.condition * before;
        bound[l] += before;
      }
    }
    s.holds = !exceeds(bound, limits.degraded);
    return s;
  }

  /// Whether pivots of earlier positions may spoil the rates.
  bool has_bad_pivots() const {
    if (!options.reuses_pivots || !has(Monitor::residual)) return false;
    return options.parts.empty() || std::ranges::any_of(options.parts, [](const PivotReuse* part) {
             return !(part->pivot_shrinkage() <= shrunk);
           });
  }

  Expectation::Signals signals_of(const Instant& instant) {
    Expectation::Signals signals;
    if (has(Monitor::residual)) signals.residual = instant.residual;
    if (!has(Monitor::sensitivity)) return signals;
    signals.growth = sensitivity.growth(instant);
    signals.drivers = sensitivity.driver_growth();
    if (!has(Monitor::clock)) return signals;
    conditioning.go_on(instant);
    if (conditioning.is_due()) conditioning.look(instant, assessor.system());
    signals.growth = std::max(signals.growth, conditioning.growth());
    return signals;
  }

  bool is_due(const Expectation::Signals& signals) const {
    return !started || degraded || after_gap || (has(Monitor::clock) && since >= options.every) ||
           !(signals.growth <= factor) || !(signals.drivers.velocity <= factor) ||
           !(signals.drivers.acceleration <= factor);
  }

  /// Of the last assessment, well enough for Continuity.
  bool rates_are_known() const { return !exceeds(last.bound, {noise, noise, noise}); }

  bool is_in_doubt(const Instant& instant, const Expectation::Signals& signals) {
    if (!has(Monitor::continuity)) return false;
    const bool in_doubt = continuity.in_doubt(instant, weights, min_excursion(signals.growth));
    return std::exchange(is_doubted, false) ? continuity.is_known() : in_doubt;
  }

  /// How far drivers may go, in magnitudes, before a position may be singular. Near a dead point
  /// z = z₀ − c x², so the way is 1/(4 c) over the square of the sensitivity; c is hardly above 4.
  double min_excursion(double growth) const {
    const double now = std::max(growth * sensitivity.largest(), 1e-300);
    return std::min(1 / (16 * now * now), conditioning.way_left() / now);
  }

  Continuity::Means means() { return {assessor, scales.now(), weights, signs}; }

  /// Goes the step again in shorter ones. Where they lead elsewhere it takes what they lead to, if
  /// that is a solution. Returns the jump otherwise.
  std::optional<Continuity::Jump> find_jump(MonitoredInstant& j, bool from_noise) {
    const auto jump = continuity.find_jump(j.instant, means());
    if (!jump || jump->crossing.kind == SingularityCrossing::Kind::passed) return jump;
    if (from_noise) return jump;  // from where shorter steps lead anywhere
    if (const auto solved = continuity.solve_anew(j.instant, means())) {
      const Assessment a = assessor(*solved, scales.with(*solved));
      if (!a.singular && !exceeds(a.bound, {noise, noise, noise})) {
        j.instant = *solved;
        j.solved_anew = true;
        ++corrected;
        return {};
      }
    }
    return jump;
  }

  void look_at_scales(const Instant& instant) {
    const Scales before = scales.now();
    if (!scales.take(instant)) return;
    rescale(worst, before, scales.now());
    expectation.rescale(before, scales.now());
    degradations.rescale(before, scales.now());
  }

  /// expected: what would have been stated.
  void assess(MonitoredInstant& j, const Expectation::Signals& signals,
              const Assessment& expected) {
    if (!started && has(Monitor::orientation)) signs.declare(j.instant);
    last = assessor(j.instant, scales.with(j.instant));
    const Assessment given = last;
    ++assessed;
    if (started && !j.instant.interpolated && exceeds(given.bound, expected.bound)) {
      look_back(j.instant);
      assessor(j.instant, scales.with(j.instant));  // its factors again
    }
    since = 0;
    const bool tries =
        has(Monitor::bounds) && exceeds(given.bound, limits.worth_correcting(given.condition));
    const bool is_better = tries && improve(j);
    const Assessment wide = last;
    if (has(Monitor::bounds)) measure(last, j.instant);
    degraded = has(Monitor::bounds) && exceeds(last.bound, limits.degraded);
    if (degraded && exceeds(last.bound, {0.5, 0.5, 0.5}))  // what is wrong is no scale
      rescale(last.bound, scales.with(j.instant), scales.now());
    else
      look_at_scales(j.instant);
    if (j.instant.interpolated)  // nothing follows for solved ones but from what it has become
      expectation.learn(last, {.growth = INFINITY});
    else
      expectation.learn(given, signals);
    if (is_better) expectation.learn(wide, {});
    if (degraded && last.condition < INFINITY)
      last.limit = assessor.limit(j.instant, scales.now(), last);
    if (!has(Monitor::bounds)) last.singular = false;
    j.degraded = degraded;
    j.assessment = last;
    if (last.condition < INFINITY) {
      sensitivity.reset(j.instant, assessor.system());
      if (weights.size() == 0) weights = sensitivity.weights();
      weights = weights.max(sensitivity.weights());
      conditioning.reset(j.instant, assessor.system());
      if (!last.singular) j.crossing = crossing(j.instant);
      started = true;
    }
    after_gap = false;
    last_time = j.instant.time;
  }

  /// Measures errors where bounds would flag an instant. Leaves its factors.
  void measure(Assessment& a, const Instant& instant) {
    if (a.singular || !exceeds(a.bound, limits.degraded)) return;
    const PerLevel<double> error = measured(instant, scales.with(instant), a.condition);
    for (const Level l : levels) a.bound[l] = std::min(a.bound[l], error[l]);
  }

  /// Whether it has become better. What was interpolated, and is not even near a solution, is
  /// solved.
  bool improve(MonitoredInstant& j) {
    if (j.instant.interpolated && exceeds(last.bound, limits.degraded)) {
      if (const auto solved = continuity.solve_anew(j.instant, means()))
        return j.solved_anew = take_if_better(j.instant, *solved);
      is_lost = true;                               // the nearest solution may be on another branch
      assessor(j.instant, scales.with(j.instant));  // its factors, after those of other instants
    }
    const Instant start = j.instant.interpolated ? continuity.driven(j.instant) : j.instant;
    return take_if_better(j.instant, assessor.corrected(start));
  }

  bool take_if_better(Instant& instant, const Instant& better) {
    const Assessment then = assessor(better, scales.with(better));
    if (!(worst_share(then) < worst_share(last))) {
      assessor(instant, scales.with(instant));  // its factors again: better has none if singular
      return false;
    }
    instant = better;
    last = then;
    ++corrected;
    return true;
  }

  /// The largest bound over its limit.
  double worst_share(const Assessment& a) const {
    double share = 0;
    for (const Level l : levels) share = std::max(share, a.bound[l] / limits.degraded[l]);
    return share;
  }

  std::optional<SingularityCrossing> crossing(const Instant& instant) {
    if (!has(Monitor::orientation)) return {};
    return !started    ? signs.at_first(instant, last, sensitivity.largest())
           : after_gap ? signs.after_gap(instant)
                       : signs.since(last_time, instant);
  }
};

AccuracyMonitor::AccuracyMonitor(const Model& m, const TimeGrid& grid,
                                 const AccuracyMonitorOptions& options)
    : state_(std::make_unique<State>(m, grid, options)) {}
AccuracyMonitor::~AccuracyMonitor() = default;

MonitoredInstant AccuracyMonitor::examine(const Instant& instant) {
  return state_->examine(instant);
}
std::optional<MonitoredInstant> AccuracyMonitor::pass(const Instant& singular) {
  return state_->pass(singular);
}
std::optional<MonitoredInstant> AccuracyMonitor::solve(const Instant& instant) {
  return state_->solve(instant);
}
AccuracyMonitor::Start AccuracyMonitor::last() const {
  if (!state_->beyond.q.empty()) return state_->beyond;
  const RecentInstants& recent = state_->continuity.recent();
  if (recent.count() == 0) return {};
  return {recent[0].state.q, recent[0].time};
}
void AccuracyMonitor::look_back(const Instant& like) { state_->look_back(like); }
void AccuracyMonitor::resume() {
  state_->after_gap = true;
  state_->continuity.forget();
}
void AccuracyMonitor::doubt_next() { state_->is_doubted = true; }
void AccuracyMonitor::shift_time(double by) {
  state_->last_time += by;
  state_->continuity.shift_time(by);
}
long AccuracyMonitor::assessed() const { return state_->assessed; }
long AccuracyMonitor::corrected() const { return state_->corrected; }
double AccuracyMonitor::condition() const { return state_->condition; }
const PerLevel<double>& AccuracyMonitor::bound() const { return state_->worst; }
long AccuracyMonitor::degraded() const { return state_->degradations.count(); }
std::optional<Degradation> AccuracyMonitor::first_degraded() const {
  return state_->degradations.first();
}

}  // namespace desmo
