#include "formulations/verification/monitor/accuracy_monitor.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "formulations/verification/assessment/assessor.h"
#include "formulations/verification/assessment/backward_error.h"
#include "formulations/verification/assessment/expectation.h"
#include "formulations/verification/assessment/limits.h"
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
/// What residuals show of errors at an estimated condition number, times this, bounds them.
constexpr double shown_by = 10;

}  // namespace

struct AccuracyMonitor::State {
  const Model& model;
  const AccuracyMonitorOptions options;
  const Limits limits;
  Assessor assessor;
  RunningScales scales;
  SensitivityMonitor sensitivity;
  ConditionMonitor conditioning;
  Continuity continuity;
  BackwardError backward_error;
  Expectation expectation{};
  BranchSigns signs;
  std::vector<EntityId> entity;  // of each coordinate

  Assessment last{};  // that was made
  double last_time = 0;
  bool started = false, degraded = false;
  bool after_gap = false, is_doubted = false;
  int since = 0;  // instants since the last assessment
  double condition = 0;
  PerLevel<double> worst{};
  Degradations degradations;
  long assessed = 0, corrected = 0;

  State(const Model& m, const TimeGrid& grid, const AccuracyMonitorOptions& o)
      : model(m),
        options(o),
        limits(o.tolerance),
        assessor(m, o.levels),
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
    const bool in_doubt = is_in_doubt(instant);
    std::optional<SingularityCrossing> jump;
    if (in_doubt && !instant.interpolated) jump = find_jump(instant);
    const bool known_before = rates_are_known();
    // A doubt that shorter steps have argued away is one: next to where solutions meet they too
    // end anywhere.
    if (in_doubt || !statement.holds || is_due(signals))
      assess(j, signals);
    else
      j.assessment = statement.assessment;
    if (in_doubt && instant.interpolated && !j.solved_anew) jump = find_jump(j.instant);
    // From rates that are noise nothing can be told; from signs of determinants it can.
    if (jump && known_before && rates_are_known()) j.crossing = jump;
    if (++since % look_every == 0) look_at_scales(j.instant);
    continuity.take(j.instant);
    if (j.assessment.singular) return j;  // which is not delivered
    condition = std::max(condition, j.assessment.condition);
    for (const Level l : levels) worst[l] = std::max(worst[l], j.assessment.bound[l]);
    if (j.degraded) degradations.add({j.instant.index, j.instant.time, j.assessment});
    return j;
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
    if (instant.interpolated || (options.reuses_pivots && has(Monitor::residual))) {
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

  bool is_in_doubt(const Instant& instant) {
    return has(Monitor::continuity) &&
           (std::exchange(is_doubted, false) ? continuity.is_known()
                                             : continuity.in_doubt(instant, sensitivity.weights()));
  }

  std::optional<SingularityCrossing> find_jump(const Instant& instant) {
    const auto jump = continuity.find_jump(instant, sensitivity.weights(), assessor);
    if (!jump) return {};
    return SingularityCrossing{jump->after, jump->before,
                               model.entities[entity[jump->coordinate]].group,
                               SingularityCrossing::Kind::jumped};
  }

  void look_at_scales(const Instant& instant) {
    const Scales before = scales.now();
    if (!scales.take(instant)) return;
    rescale(worst, before, scales.now());
    expectation.rescale(before, scales.now());
    degradations.rescale(before, scales.now());
  }

  void assess(MonitoredInstant& j, const Expectation::Signals& signals) {
    if (!started && has(Monitor::orientation)) signs.declare(j.instant);
    last = assessor(j.instant, scales.with(j.instant));
    const Assessment given = last;
    ++assessed;
    since = 0;
    const bool tries =
        has(Monitor::bounds) && exceeds(given.bound, limits.worth_correcting(given.condition));
    const bool is_better = tries && improve(j);
    look_at_scales(j.instant);
    if (j.instant.interpolated)  // nothing follows for solved ones but from what it has become
      expectation.learn(last, {.growth = INFINITY});
    else
      expectation.learn(given, signals);
    if (is_better) expectation.learn(last, {});
    degraded = has(Monitor::bounds) && exceeds(last.bound, limits.degraded);
    if (degraded && last.condition < INFINITY)
      last.limit = assessor.limit(j.instant, scales.now(), last);
    if (!has(Monitor::bounds)) last.singular = false;
    j.degraded = degraded;
    j.assessment = last;
    if (last.condition < INFINITY) {
      sensitivity.reset(j.instant, assessor.system());
      conditioning.reset(assessor.system());
      if (!last.singular) j.crossing = crossing(j.instant);
      started = true;
    }
    after_gap = false;
    last_time = j.instant.time;
  }

  /// Whether it has become better. What was interpolated, and is not even near a solution, is
  /// solved.
  bool improve(MonitoredInstant& j) {
    if (j.instant.interpolated && exceeds(last.bound, limits.degraded)) {
      if (const auto solved = continuity.solve_anew(j.instant, sensitivity.weights(), assessor))
        return j.solved_anew = take_if_better(j.instant, *solved);
      assessor(j.instant, scales.with(j.instant));  // its factors, after those of other instants
    }
    const Instant start = j.instant.interpolated ? continuity.driven(j.instant) : j.instant;
    return take_if_better(j.instant, assessor.corrected(start));
  }

  bool take_if_better(Instant& instant, const Instant& better) {
    const Assessment then = assessor(better, scales.with(better));
    if (!(worst_share(then) < worst_share(last))) return false;
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
