#include "formulations/safety/watch.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "formulations/accuracy/condition.h"
#include "formulations/safety/assessor.h"
#include "formulations/safety/branch_signs.h"
#include "formulations/safety/condition_monitor.h"
#include "formulations/safety/continuity.h"
#include "formulations/safety/expectation.h"
#include "formulations/safety/gain_monitor.h"
#include "formulations/safety/limits.h"
#include "formulations/safety/running_scales.h"

namespace desmo {

namespace {

/// By how much the gain may grow before an instant is assessed.
constexpr double factor = 4;
/// Instants from one look at the scales to the next: they grow slowly, and small ones are safe.
constexpr int look_every = 16;
/// Limits of the bounds, over the tolerance, and their square and cube at the other levels: above
/// the first an instant is corrected, and above the second, after that, it is degraded.
constexpr double worth_correcting = 10, allowed_error = 100;
/// Bounds up to so many times what conditioning allows (accuracy_limit) are not corrected either.
constexpr double over_floor = 10;
constexpr double unit_roundoff = 0x1p-53;
/// Bounds of rates above which it cannot be told whether they lead on.
constexpr double noise = 1e-3;
/// By how much a bound may rise above what correcting could reach.
constexpr double worse = 2;

}  // namespace

struct Watch::State {
  const Mechanism& mechanism;
  const Options options;
  const PerLevel<double> limit, correctable;
  Assessor assessor;
  RunningScales scales;
  GainMonitor gain;
  ConditionMonitor conditioning;
  Continuity continuity;
  Expectation expectation{};
  BranchSigns signs;
  std::vector<EntityId> entity;  // of each coordinate

  Assessment last{};             // that was made
  PerLevel<double> reachable{};  // bounds that correcting has led to, or might
  double last_time = 0;
  bool started = false, degraded = false;
  bool after_gap = false;
  int since = 0;  // instants since the last assessment
  double condition = 0;
  PerLevel<double> worst{};
  long assessed = 0, corrected = 0;

  State(const Mechanism& m, const TimeGrid& grid, const Options& o)
      : mechanism(m),
        options(o),
        limit(powers(allowed_error, o.tolerance)),
        correctable(powers(worth_correcting, o.tolerance)),
        assessor(m, o.levels),
        scales(m, grid),
        gain(m, assessor.levels(), assessor.system().magnitudes()),
        conditioning(m, assessor.system()),
        continuity(m, assessor.system().magnitudes()),
        signs(m, assessor.system()),
        entity(entity_of_coordinate(m)) {}

  bool has(Monitor monitor) const { return !(options.without & static_cast<unsigned>(monitor)); }

  Judgement judge(const Instant& instant) {
    Judgement j{instant};
    const double growth = growth_at(instant);
    const double residual = has(Monitor::residual) ? instant.residual : 0;
    const Assessment expected = expectation(growth, residual);
    const bool in_doubt = is_in_doubt(instant);
    const std::optional<Crossing> jump = in_doubt ? find_jump(instant) : std::nullopt;
    const bool known_before = rates_are_known();
    // A doubt that shorter steps have argued away is one: next to where solutions meet they too
    // end anywhere.
    if (in_doubt || is_due(growth, residual, expected))
      assess(j, growth, residual);
    else
      j.assessment = expectation.with_margin(expected);
    // From rates that are noise nothing can be told; from signs of determinants it can.
    if (jump && known_before && rates_are_known()) j.crossing = jump;
    if (++since % look_every == 0) look_at_scales(instant);
    continuity.take(j.instant);
    condition = std::max(condition, j.assessment.condition);
    for (const Level l : levels) worst[l] = std::max(worst[l], j.assessment.bound[l]);
    return j;
  }

  /// Of the condition number since the last assessment, as far as it shows.
  double growth_at(const Instant& instant) {
    if (!has(Monitor::gain)) return 1;
    const double of_rates = gain.growth(instant);
    if (!has(Monitor::clock)) return of_rates;
    conditioning.go_on(instant);
    if (conditioning.is_due()) conditioning.look(instant, assessor.system());
    return std::max(of_rates, conditioning.growth());
  }

  bool is_due(double growth, double residual, const Assessment& expected) const {
    return !started || degraded || after_gap || (has(Monitor::clock) && since >= options.every) ||
           !(growth <= factor) || expectation.is_new(residual) || is_correctable(expected, growth);
  }

  /// Whether bounds are so large that correcting would help.
  bool is_correctable(const Assessment& a, double growth) const {
    const PerLevel<double> least = worth_correcting_at(a.condition);
    double powers_of_growth = worse;
    return std::ranges::any_of(levels, [&](Level l) {
      powers_of_growth *= growth;
      return !(a.bound[l] <= std::max(least[l], powers_of_growth * reachable[l]));
    });
  }

  /// The bounds above which an instant of that condition number is corrected.
  PerLevel<double> worth_correcting_at(double kappa) const {
    PerLevel<double> least = accuracy_limit(kappa, over_floor * unit_roundoff);
    for (const Level l : levels) least[l] = std::max(least[l], correctable[l]);
    return least;
  }

  /// Of the last assessment, well enough for Continuity.
  bool rates_are_known() const { return !exceeds(last.bound, {noise, noise, noise}); }

  bool is_in_doubt(const Instant& instant) const {
    return has(Monitor::continuity) && continuity.in_doubt(instant, gain.weights());
  }

  std::optional<Crossing> find_jump(const Instant& instant) {
    const auto jump = continuity.find_jump(instant, gain.weights(), assessor);
    if (!jump) return {};
    return Crossing{jump->after, jump->before, mechanism.entities[entity[jump->coordinate]].group,
                    Crossing::Kind::jumped};
  }

  void look_at_scales(const Instant& instant) {
    const Scales before = scales.now();
    if (!scales.take(instant)) return;
    rescale(worst, before, scales.now());
    rescale(reachable, before, scales.now());
    expectation.rescale(before, scales.now());
  }

  void assess(Judgement& j, double growth, double residual) {
    if (!started && has(Monitor::orientation)) signs.declare(j.instant);
    last = assessor(j.instant, scales.with(j.instant));
    const Assessment given = last;
    ++assessed;
    since = 0;
    const bool tries =
        has(Monitor::bounds) && exceeds(given.bound, worth_correcting_at(given.condition));
    const bool is_better = tries && correct(j.instant);
    look_at_scales(j.instant);
    reachable = tries ? last.bound : PerLevel<double>{};
    expectation.learn(given, growth, residual);
    if (is_better) expectation.learn(last, 1, 0);
    degraded = has(Monitor::bounds) && exceeds(last.bound, limit);
    if (!has(Monitor::bounds)) last.singular = false;
    j.degraded = degraded;
    j.assessment = last;
    if (last.condition < INFINITY) {
      gain.reset(j.instant, assessor.system());
      conditioning.reset(assessor.system());
      j.crossing = crossing(j.instant);
      started = true;
    }
    after_gap = false;
    last_time = j.instant.time;
  }

  /// Whether it has become better.
  bool correct(Instant& instant) {
    const Instant better = assessor.corrected(instant);
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
    for (const Level l : levels) share = std::max(share, a.bound[l] / limit[l]);
    return share;
  }

  std::optional<Crossing> crossing(const Instant& instant) {
    if (!has(Monitor::orientation)) return {};
    return !started    ? signs.at_first(instant, last, gain.largest())
           : after_gap ? signs.after_gap(instant)
                       : signs.since(last_time, instant);
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
