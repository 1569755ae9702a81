#include "formulations/safety/watch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "formulations/safety/assessor.h"
#include "formulations/safety/gain_monitor.h"
#include "formulations/safety/running_scales.h"

namespace desmo {

namespace {

/// By how much a signal may move before an instant is assessed.
constexpr double factor = 4;
/// Residuals below it are rounding.
constexpr double least_residual = 1e-15;
/// Rounding of an equation, relative to its terms.
constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();
/// Limits of the bounds, over the tolerance: this, its square and its cube.
constexpr double allowed = 100;

PerLevel<double> limits(double tolerance) {
  const double t = std::max(tolerance, std::numeric_limits<double>::epsilon());
  return {allowed * t, allowed * allowed * t, allowed * allowed * allowed * t};
}

bool exceeds(const PerLevel<double>& bound, const PerLevel<double>& limit) {
  return std::ranges::any_of(levels, [&](Level l) { return !(bound[l] <= limit[l]); });
}

/// Bounds relative to scales that have grown since.
void rescale(PerLevel<double>& bound, const Scales& from, const Scales& to) {
  for (const Level l : {Level::velocity, Level::acceleration}) {
    const auto share = [&](double before, double now) { return now > 0 ? before / now : 1; };
    bound[l] *=
        std::max(share(from.length[l], to.length[l]), share(from.rotation[l], to.rotation[l]));
  }
}

/// What bounds become when the condition number is `growth` times as large and the position is off
/// by `position` (or as before, if that is more).
PerLevel<double> extrapolated(const PerLevel<double>& bound, double growth, double position) {
  const double q = std::max(bound.position, position) * growth;
  const double share = bound.position > 0 ? q / bound.position : 1;
  return {q, bound.velocity * share * growth, bound.acceleration * share * growth * growth};
}

}  // namespace

struct Watch::State {
  Options options;
  PerLevel<double> limit;
  Assessor assessor;
  RunningScales scales;
  GainMonitor gain;

  Assessment last{};  // that was made
  std::vector<signed char> orientation{};
  double last_time = 0;
  bool started = false, degraded = false;
  int since = 0;              // instants since the last assessment
  double worst_residual = 0;  // of those assessed
  double amplification = 0;   // of residuals, the largest seen
  double condition = 0;
  PerLevel<double> worst{};
  long assessed = 0, corrected = 0;

  State(const Mechanism& m, const TimeGrid& grid, const Options& o)
      : options(o),
        limit(limits(o.tolerance)),
        assessor(m, o.levels),
        scales(m, grid),
        gain(m, assessor.levels()) {}

  bool has(Monitor monitor) const { return !(options.without & static_cast<unsigned>(monitor)); }

  bool is_due(double growth, double residual, const PerLevel<double>& expected) const {
    return !started || degraded || (has(Monitor::clock) && since >= options.every) ||
           !(growth <= factor) || exceeds(expected, limit) ||
           (has(Monitor::residual) && residual > least_residual &&
            residual > factor * worst_residual);
  }

  Judgement judge(const Instant& instant) {
    const Scales before = scales.now();
    if (scales.take(instant)) rescale(worst, before, scales.now());
    const double growth = gain.growth(instant);
    const double counted_growth = has(Monitor::gain) ? growth : 1;
    const double residual = has(Monitor::residual) ? instant.residual : 0;
    Judgement j{instant, false, {}, last};
    j.assessment.condition *= counted_growth;
    j.assessment.bound = extrapolated(last.bound, counted_growth, amplification * residual);
    ++since;
    if (is_due(counted_growth, residual, j.assessment.bound))
      assess(j);
    else  // what rounding may do where its assessment was lucky
      j.assessment.bound.position =
          std::max(j.assessment.bound.position, rounding * j.assessment.condition);
    condition = std::max(condition, j.assessment.condition);
    for (const Level l : levels) worst[l] = std::max(worst[l], j.assessment.bound[l]);
    return j;
  }

  void assess(Judgement& j) {
    last = assessor(j.instant, scales.now());
    ++assessed;
    since = 0;
    worst_residual = std::max(worst_residual, j.instant.residual);
    if (j.instant.residual > least_residual && !last.singular)
      amplification = std::max(amplification, last.bound.position / j.instant.residual);
    if (has(Monitor::bounds) && exceeds(last.bound, limit)) correct(j.instant);
    degraded = has(Monitor::bounds) && exceeds(last.bound, limit);
    if (!has(Monitor::bounds)) last.singular = false;
    j.degraded = degraded;
    j.assessment = last;
    if (last.condition < INFINITY) {
      gain.reset(assessor.system());
      if (has(Monitor::orientation)) j.crossing = crossing(j.instant.time);
      started = true;
    }
    last_time = j.instant.time;
  }

  void correct(Instant& instant) {
    const Instant better = assessor.corrected(instant);
    const Assessment then = assessor(better, scales.now());
    if (!then.singular || last.singular) {
      instant = better;
      last = then;
      ++corrected;
    }
  }

  std::optional<Crossing> crossing(double time) {
    const auto now = assessor.system().orientation();
    std::optional<Crossing> found;
    for (std::size_t b = 0; b < now.size() && started && !found; ++b)
      if (now[b] != orientation[b])
        found = {last_time, time, assessor.system().group_of_block(static_cast<int>(b))};
    orientation.assign(now.begin(), now.end());
    return found;
  }
};

Watch::Watch(const Mechanism& m, const TimeGrid& grid, const Options& options)
    : state_(std::make_unique<State>(m, grid, options)) {}
Watch::~Watch() = default;

Watch::Judgement Watch::judge(const Instant& instant) { return state_->judge(instant); }
long Watch::assessed() const { return state_->assessed; }
long Watch::corrected() const { return state_->corrected; }
double Watch::condition() const { return state_->condition; }
const PerLevel<double>& Watch::bound() const { return state_->worst; }

}  // namespace desmo
