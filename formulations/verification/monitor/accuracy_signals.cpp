#include <algorithm>
#include <utility>

#include "formulations/algebra/linear_solver.h"
#include "formulations/verification/monitor/accuracy_state.h"

namespace desmo {

namespace {

/// By how much the gain may grow before an instant is assessed.
constexpr double factor = 4;
/// By how much pivots may shrink before residuals of rates are looked at.
constexpr double shrunk = 20;
/// What residuals show of errors at an estimated condition number, times this, bounds them.
constexpr double shown_by = 10;

}  // namespace

Expectation::Signals AccuracyMonitor::State::signals_of(const Instant& instant) {
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

bool AccuracyMonitor::State::is_due(const Expectation::Signals& signals) const {
  return !started || degraded || after_gap || (has(Monitor::clock) && since >= options.every) ||
         !(signals.growth <= factor) || !(signals.drivers.velocity <= factor) ||
         !(signals.drivers.acceleration <= factor);
}

AccuracyMonitor::State::Statement AccuracyMonitor::State::state(const Instant& instant,
                                                                const Assessment& expected) {
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
bool AccuracyMonitor::State::has_bad_pivots() const {
  if (!options.reuses_pivots || !has(Monitor::residual)) return false;
  return options.parts.empty() || std::ranges::any_of(options.parts, [](const PivotReuse* part) {
           return !(part->pivot_shrinkage() <= shrunk);
         });
}

bool AccuracyMonitor::State::is_in_doubt(const Instant& instant,
                                         const Expectation::Signals& signals) {
  if (!has(Monitor::continuity)) return false;
  const bool in_doubt = continuity.in_doubt(instant, weights, min_excursion(signals.growth));
  return std::exchange(is_doubted, false) ? continuity.is_known() : in_doubt;
}

/// How far drivers may go, in magnitudes, before a position may be singular. Near a dead point
/// z = z₀ − c x², so the way is 1/(4 c) over the square of the sensitivity; c is hardly above 4.
double AccuracyMonitor::State::min_excursion(double growth) const {
  const double now = std::max(growth * sensitivity.largest(), 1e-300);
  return std::min(1 / (16 * now * now), conditioning.way_left() / now);
}

}  // namespace desmo
