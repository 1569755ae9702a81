#include "formulations/safety/watch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "formulations/safety/assessor.h"
#include "formulations/safety/continuity.h"
#include "formulations/safety/gain_monitor.h"
#include "formulations/safety/running_scales.h"

namespace desmo {

namespace {

/// By how much a signal may move before an instant is assessed.
constexpr double factor = 4;
/// Instants from one look at the scales to the next: they grow slowly, and small ones are safe.
constexpr int look_every = 16;
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
  Continuity continuity;
  std::vector<EntityId> entity;  // of each coordinate
  const Mechanism& mechanism;

  Assessment last{};  // that was made
  std::vector<signed char> orientation{};
  double last_time = 0;
  bool started = false, degraded = false;
  bool after_gap = false;
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
        gain(m, assessor.levels()),
        continuity(m),
        entity(entity_of_coordinate(m)),
        mechanism(m) {}

  bool has(Monitor monitor) const { return !(options.without & static_cast<unsigned>(monitor)); }

  bool is_due(double growth, double residual, const PerLevel<double>& expected) const {
    return !started || degraded || after_gap || (has(Monitor::clock) && since >= options.every) ||
           !(growth <= factor) || exceeds(expected, limit) ||
           (has(Monitor::residual) && residual > least_residual &&
            residual > factor * worst_residual);
  }

  Judgement judge(const Instant& instant) {
    const double growth = has(Monitor::gain) ? gain.growth(instant) : 1;
    const double residual = has(Monitor::residual) ? instant.residual : 0;
    Judgement j{instant, false, {}, last};
    j.assessment.condition *= growth;
    j.assessment.bound = extrapolated(last.bound, growth, amplification * residual);
    find_jump(j);
    const bool due = j.crossing || is_due(growth, residual, j.assessment.bound);
    if (due || ++since % look_every == 0) look_at_scales(instant);
    if (due)
      assess(j);
    else
      allow_for_the_unseen(j.assessment);
    continuity.take(j.instant);
    condition = std::max(condition, j.assessment.condition);
    for (const Level l : levels) worst[l] = std::max(worst[l], j.assessment.bound[l]);
    return j;
  }

  /// Signals that move by less than `factor`, and rounding where an assessment was lucky.
  static void allow_for_the_unseen(Assessment& a) {
    for (const Level l : levels) a.bound[l] *= factor;
    a.bound.position = std::max(a.bound.position, rounding * a.condition);
  }

  void find_jump(Judgement& j) {
    if (!has(Monitor::continuity) || !continuity.in_doubt(j.instant, gain.weights())) return;
    if (const auto jump = continuity.find_jump(j.instant, gain.weights(), assessor))
      j.crossing = {jump->after, jump->before, mechanism.entities[entity[jump->coordinate]].group,
                    true};
  }

  void look_at_scales(const Instant& instant) {
    const Scales before = scales.now();
    if (scales.take(instant)) rescale(worst, before, scales.now());
  }

  void assess(Judgement& j) {
    last = assessor(j.instant, scales.now());
    ++assessed;
    since = 0;
    after_gap = false;
    worst_residual = std::max(worst_residual, j.instant.residual);
    if (j.instant.residual > least_residual && !last.singular)
      amplification = std::max(amplification, last.bound.position / j.instant.residual);
    if (has(Monitor::bounds) && exceeds(last.bound, limit)) correct(j.instant);
    degraded = has(Monitor::bounds) && exceeds(last.bound, limit);
    if (!has(Monitor::bounds)) last.singular = false;
    j.degraded = degraded;
    j.assessment = last;
    if (last.condition < INFINITY) {
      gain.reset(j.instant, assessor.system());
      const std::optional<Crossing> crossed = crossing(j.instant.time);
      if (!j.crossing) j.crossing = crossed;
      started = true;
    }
    last_time = j.instant.time;
  }

  void correct(Instant& instant) {
    const Instant better = assessor.corrected(instant);
    const Assessment then = assessor(better, scales.now());
    if (last.singular || then.bound.position <= last.bound.position) {
      instant = better;
      last = then;
      ++corrected;
    }
  }

  std::optional<Crossing> crossing(double time) {
    const auto now = assessor.system().orientation();
    std::optional<Crossing> found;
    for (std::size_t b = 0; has(Monitor::orientation) && b < now.size() && started && !found; ++b)
      if (now[b] != orientation[b])
        found = {last_time, time, assessor.system().group_of_block(static_cast<int>(b)), false};
    orientation.assign(now.begin(), now.end());
    return found;
  }
};

Watch::Watch(const Mechanism& m, const TimeGrid& grid, const Options& options)
    : state_(std::make_unique<State>(m, grid, options)) {}
Watch::~Watch() = default;

Watch::Judgement Watch::judge(const Instant& instant) { return state_->judge(instant); }
void Watch::resume() {
  state_->after_gap = true;
  state_->continuity.forget();
}
long Watch::assessed() const { return state_->assessed; }
long Watch::corrected() const { return state_->corrected; }
double Watch::condition() const { return state_->condition; }
const PerLevel<double>& Watch::bound() const { return state_->worst; }

}  // namespace desmo
