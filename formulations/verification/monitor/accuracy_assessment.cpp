#include <algorithm>
#include <cmath>
#include <utility>

#include "formulations/base/part.h"
#include "formulations/verification/monitor/accuracy_state.h"

namespace desmo {

namespace {

/// By how much the gain may grow before an instant is assessed.
constexpr double growth_to_assess = 4;
/// By how much pivots may shrink before residuals of rates are looked at.
constexpr double doubtful_pivot_loss = 20;
/// What residuals show of errors at an estimated condition number, times this, bounds them.
constexpr double error_over_shown = 10;

}  // namespace

/// Measures the step to an instant that has velocities, once there is something to measure by.
std::optional<StepMeasures> AccuracyMonitor::State::measure_step(const Instant& instant) {
  RecentInstants& recent = continuity.recent();
  if (!started || recent.count() == 0 || instant.qd.empty()) {
    recent.forget_copy();
    return {};
  }
  StepMeasures step = recent.measure(instant, sensitivity.weights().data());
  step.mismatch *= max_weight_ratio;
  step.is_bound = max_weight_ratio > 1;
  return step;
}

Expectation::Signals AccuracyMonitor::State::signals_of(const Instant& instant,
                                                        const std::optional<StepMeasures>& step) {
  Expectation::Signals signals;
  if (has(Monitor::residual)) signals.residual = instant.residual;
  if (has(Monitor::sensitivity)) {
    signals.rates = sensitivity.growth(instant, step ? std::optional(step->rate) : std::nullopt);
    signals.drivers = sensitivity.driver_growth();
  }
  signals.growth = signals.rates;
  if (!has(Monitor::condition)) return signals;
  conditioning.go_on(instant, ways(instant, step));
  if (conditioning.is_due()) conditioning.look(instant, assessor.system());
  signals.growth = std::max(signals.growth, conditioning.growth());
  if (!has(Monitor::sensitivity)) signals.rates = signals.growth;  // not known
  return signals;
}

/// How far drivers and unknowns have moved at most in the step to an instant.
ConditionMonitor::Ways AccuracyMonitor::State::ways(const Instant& instant,
                                                    const std::optional<StepMeasures>& step) {
  ConditionMonitor::Ways now;
  if (step && has(Monitor::sensitivity)) now = {sensitivity.drivers(), step->rate};
  const ConditionMonitor::Ways before = std::exchange(speeds, now);
  const double h = step ? std::abs(instant.time - continuity.recent()[0].time) : 1;
  return {h * std::max(before.drivers, now.drivers), h * std::max(before.unknowns, now.unknowns)};
}

bool AccuracyMonitor::State::is_due(const Expectation::Signals& signals) const {
  return !started || degraded || after_gap || chosen || options.assesses_all ||
         !(signals.growth <= growth_to_assess) || !(signals.drivers.velocity <= growth_to_assess) ||
         !(signals.drivers.acceleration <= growth_to_assess);
}

AccuracyMonitor::State::Statement AccuracyMonitor::State::state(const Instant& instant,
                                                                const Assessment& expected) {
  Statement s{expected, true};
  if (!has(Monitor::bounds) || !started) return s;
  PerLevel<double>& bound = s.assessment.bound;
  if (instant.interpolated || has_bad_pivots()) {
    const PerLevel<double> shown = backward_error(instant, scales.current(), expected.condition);
    if (instant.interpolated) bound.position += error_over_shown * shown.position;
    // Of solved positions the residual tells, with what they make of rates.
    double before = instant.interpolated ? bound.position : 0;
    for (const Level l : {Level::velocity, Level::acceleration}) {
      before = error_over_shown * shown[l] + expected.condition * before;
      bound[l] += before;
    }
  }
  s.holds = !exceeds(bound, limits.degraded);
  return s;
}

/// Whether pivots of earlier positions may spoil the rates.
bool AccuracyMonitor::State::has_bad_pivots() const {
  if (!options.reuses_pivots || !has(Monitor::pivots)) return false;
  return options.parts.empty() || std::ranges::any_of(options.parts, [](const Part* part) {
           const Pivots pivots = part->pivots();
           return pivots.square_condition || !(pivots.shrinkage <= doubtful_pivot_loss);
         });
}

bool AccuracyMonitor::State::is_in_doubt(const Instant& instant,
                                         const Expectation::Signals& signals,
                                         const std::optional<StepMeasures>& step) {
  if (!has(Monitor::continuity)) return false;
  const Instant known = with_known_rates(instant);
  const bool is_measured = step && known.qdd.size() == instant.qdd.size();
  const bool in_doubt = continuity.in_doubt(known, weights, min_excursion(signals.growth),
                                            is_measured ? step : std::nullopt, has(Monitor::turns));
  return std::exchange(is_doubted, false) ? continuity.is_known() : in_doubt;
}

/// How far drivers may go, in magnitudes, before a position may be singular. Near a dead point
/// z = z₀ − c x², so the way is 1/(4 c) over the square of the sensitivity; c is hardly above 4.
double AccuracyMonitor::State::min_excursion(double growth) const {
  const double now = std::max(growth * sensitivity.largest(), 1e-300);
  return std::min(1 / (16 * now * now), conditioning.way_left() / now);
}

/// Assesses an instant, and corrects it where that helps. An interpolated instant that is too
/// coarse leaves no trace.
void AccuracyMonitor::State::assess(MonitoredInstant& j, const Expectation::Signals& signals,
                                    bool in_doubt) {
  if (!started && !is_declared && has(Monitor::orientation)) signs.declare(j.instant);
  const Assessment given = assessor(j.instant, scales.with(j.instant));
  ++assessed;
  if (j.instant.interpolated) {
    j.too_coarse = is_too_coarse(j.instant, given, in_doubt);
    if (j.too_coarse) return;
    assessor(j.instant, scales.with(j.instant));  // its factors again
  }
  last = given;
  since = 0;
  const bool tries = has(Monitor::bounds) && has(Monitor::repair) && !j.instant.interpolated &&
                     exceeds(given.bound, limits.worth_correcting(given.condition));
  const bool is_better = tries && improve(j);
  const Assessment wide = last;
  if (has(Monitor::bounds) && has(Monitor::measurement)) measure(last, j.instant);
  degraded = has(Monitor::bounds) && exceeds(last.bound, limits.degraded);
  if (degraded && exceeds(last.bound, {0.5, 0.5, 0.5}))  // what is wrong is no scale
    rescale(last.bound, scales.with(j.instant), scales.current());
  else
    look_at_scales(j.instant);
  if (j.instant.interpolated)  // nothing follows for solved ones but from what it has become
    expectation.learn(last, {.growth = INFINITY});
  else
    expectation.learn(given, signals);
  if (is_better) expectation.learn(wide, {});
  if (degraded && last.condition < INFINITY)
    last.limit = has(Monitor::cause) ? assessor.limit(j.instant, scales.current(), last)
                                     : Limit::singular_position;
  if (!has(Monitor::bounds)) last.singular = false;
  j.degraded = degraded;
  j.assessment = last;
  if (last.condition < INFINITY) {
    sensitivity.reset(j.instant, assessor.system());
    if (weights.size() == 0) weights = sensitivity.weights();
    weights = weights.max(sensitivity.weights());
    const Eigen::ArrayXd& now = sensitivity.weights();
    max_weight_ratio = (weights > 0).select(weights / now, 1).maxCoeff();
    speeds = {};
    conditioning.reset(j.instant, assessor.system(), now);
    backward_error.take_row_sums(assessor.system());
    if (!last.singular) j.crossing = crossing(j.instant);
    started = true;
  }
  after_gap = false;
}

/// Whether an interpolated instant exceeds the limits, or is not where the instant before leads. a:
/// its assessment, whose factors are overwritten.
bool AccuracyMonitor::State::is_too_coarse(const Instant& instant, const Assessment& a,
                                           bool in_doubt) {
  if (has(Monitor::bounds) && exceeds(a.bound, limits.degraded)) return true;
  return in_doubt && continuity.find_jump(with_known_rates(instant), means());
}

/// Measures errors where bounds would flag an instant. Leaves its factors.
void AccuracyMonitor::State::measure(Assessment& a, const Instant& instant) {
  if (a.singular || !exceeds(a.bound, limits.degraded)) return;
  const PerLevel<double> error = measured(instant, scales.with(instant), a, limits.degraded);
  for (const Level l : all_levels) a.bound[l] = std::min(a.bound[l], error[l]);
}

/// Corrects an instant.
bool AccuracyMonitor::State::improve(MonitoredInstant& j) {
  return take_if_better(j.instant, assessor.corrected(j.instant));
}

bool AccuracyMonitor::State::take_if_better(Instant& instant, const Instant& better) {
  const Assessment then = assessor(better, scales.with(better));
  if (!(worst_share(then) < worst_share(last))) {
    assessor(instant, scales.with(instant));  // its factors again: better has none if singular
    return false;
  }
  instant = kept(better);
  last = then;
  ++corrected;
  return true;
}

/// Copies an instant that others would overwrite before it is delivered.
Instant AccuracyMonitor::State::kept(const Instant& instant) {
  improved.q.assign(instant.q.begin(), instant.q.end());
  improved.qd.assign(instant.qd.begin(), instant.qd.end());
  improved.qdd.assign(instant.qdd.begin(), instant.qdd.end());
  Instant result = instant;
  result.q = improved.q, result.qd = improved.qd, result.qdd = improved.qdd;
  return result;
}

/// The largest bound over its limit.
double AccuracyMonitor::State::worst_share(const Assessment& a) const {
  double share = 0;
  for (const Level l : all_levels) share = std::max(share, a.bound[l] / limits.degraded[l]);
  return share;
}

std::optional<SingularityCrossing> AccuracyMonitor::State::crossing(const Instant& instant) {
  if (!has(Monitor::orientation)) return {};
  if (!started) {
    if (!is_declared) return signs.at_first(instant, last, sensitivity.largest());
    signs.begin();
    return {};
  }
  return after_gap ? signs.after_gap(instant) : signs.since(last_time, instant);
}

void AccuracyMonitor::State::look_at_scales(const Instant& instant) {
  const Scales before = scales.current();
  if (scales.take(instant)) follow_scales(before);
}

void AccuracyMonitor::State::follow_scales(const Scales& before) {
  expectation.rescale(before, scales.current());
  if (!has(Monitor::scales)) return;  // what was stated of an instant is relative to it
  rescale(worst, before, scales.current());
  rescale(worst_before, before, scales.current());
  degradations.rescale(before, scales.current());
}

}  // namespace desmo
