#include "formulations/verification/monitor/accuracy_monitor.h"

#include <algorithm>
#include <cmath>

#include "formulations/verification/assessment/nominal_continuation.h"
#include "formulations/verification/condition.h"
#include "formulations/verification/monitor/accuracy_state.h"

namespace desmo {

namespace {

/// Instants from one look at the scales to the next: they grow slowly, and small ones are safe.
constexpr int look_every = 16;

}  // namespace

AccuracyMonitor::State::State(const Model& m, const TimeGrid& grid, const AccuracyMonitorOptions& o)
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
      degradations(limits.degraded, o.max_degradations) {
  for (std::vector<double>* values : {&improved.q, &improved.qd, &improved.qdd})
    values->reserve(m.coordinates());
}

MonitoredInstant AccuracyMonitor::State::examine(const Instant& given) {
  MonitoredInstant j{given};
  if (given.interpolated && !has(Monitor::rows)) return j;
  if (!started) declare(j);
  const Instant instant = j.instant;
  const std::optional<StepMeasures> step = measure_step(instant);
  const Expectation::Signals signals = signals_of(instant, step);
  const Assessment expected = expectation(signals);
  const Statement statement = state(instant, expected);
  // A shorter stride costs less than an assessment.
  if (j.too_coarse = instant.interpolated && !statement.holds; j.too_coarse) return j;
  const bool in_doubt = is_in_doubt(instant, signals, step);
  j.angles_follow = !in_doubt && has(Monitor::continuity) && continuity.angles_follow();
  std::optional<Continuity::Jump> jump;
  const bool known_before = rates_are_known(), from_noise = degraded && !known_before;
  // Accelerations that are noise raise doubts; where velocities are known, shorter steps settle
  // them.
  const bool is_blind =
      in_doubt && degraded && exceeds(last.bound, {unusable_rate, unusable_rate, INFINITY});
  if (in_doubt && !instant.interpolated) jump = find_jump(j, from_noise);
  // A doubt remains one even where shorter steps agree: next to where solutions meet, they too
  // may end on another branch.
  const bool is_assessed = in_doubt || !statement.holds || is_due(signals);
  if (is_assessed)
    assess(j, signals, statement.assessment, in_doubt);
  else
    j.assessment = statement.assessment;
  if (j.assessment.singular && !instant.interpolated && has(Monitor::repair))
    solve_singular(j, signals);
  if (j.too_coarse) return j;
  // Nobody can tell where a doubtful step from rates that are noise leads.
  if (jump && (jump->at_turn || from_noise || (known_before && rates_are_known())))
    j.crossing = jump->crossing;
  else if (is_blind && continuity.is_known() && !j.crossing)
    j.crossing = {continuity.recent()[0].time, instant.time, last.group,
                  SingularityCrossing::Kind::jumped};
  if (j.assessment.singular) return j;  // which is not delivered
  if (++since % look_every == 0 && !is_assessed) look_at_scales(j.instant);
  deliver(j, is_assessed);
  return j;
}

/// Counts an instant that is delivered, and keeps it to go on from.
void AccuracyMonitor::State::deliver(const MonitoredInstant& j, bool is_assessed) {
  continuity.take(j.instant, is_assessed, j.assessment.bound);
  if (is_assessed) {
    signs.accept();
    last_time = j.instant.time;
  }
  beyond = {};
  condition = std::max(condition, j.assessment.condition);
  add({j.instant.index, j.instant.time, j.assessment}, j.degraded);
}

void AccuracyMonitor::State::add(const Degradation& d, bool is_degraded) {
  for (const Level l : levels) worst[l] = std::max(worst[l], d.assessment.bound[l]);
  if (is_degraded) degradations.add(d);
}

/// Goes the step again in shorter ones. Where they lead elsewhere it takes what they lead to, if
/// that is a solution. Returns the jump otherwise.
std::optional<Continuity::Jump> AccuracyMonitor::State::find_jump(MonitoredInstant& j,
                                                                  bool from_noise) {
  const auto jump = continuity.find_jump(with_known_rates(j.instant), means());
  if (!jump || jump->crossing.kind == SingularityCrossing::Kind::passed) return jump;
  if (from_noise || !has(Monitor::repair)) return jump;  // from where shorter steps lead anywhere
  if (const auto solved = solve_anew(j.instant)) {
    const Instant found = kept(*solved);
    Assessment a = assessor(found, scales.with(found));
    measure(a, found);
    if (!a.singular && !exceeds(a.bound, {unusable_rate, unusable_rate, unusable_rate})) {
      j.instant = found;
      j.solved_anew = true;
      ++corrected;
      return {};
    }
  }
  return jump;
}

std::optional<MonitoredInstant> AccuracyMonitor::State::solve(const Instant& instant) {
  const auto solved = continuity.is_known() ? solve_from_last(instant) : solve_alone(instant);
  if (!solved) return {};
  MonitoredInstant j{kept(*solved)};
  j.solved_anew = true;
  assess(j, signals_of(j.instant, {}), {}, false);
  if (j.assessment.singular) return {};
  deliver(j, true);
  ++corrected;
  return j;
}

std::optional<Instant> AccuracyMonitor::State::solve_from_last(const Instant& instant) {
  continuity.expect(instant);
  return solve_anew(instant);
}

std::optional<MonitoredInstant> AccuracyMonitor::State::solve_again(const Instant& instant) {
  RecentInstants& recent = continuity.recent();
  if (recent.count() > 0 && recent[0].is_assessed) signs.take_back();
  recent.drop();
  if (!continuity.is_known()) return {};
  const auto solved = solve(instant);
  return solved ? solved : pass(instant);
}

/// Solves an instant anew that looks singular where it is: it may be off. Returns whether it is
/// regular after all.
bool AccuracyMonitor::State::solve_singular(MonitoredInstant& j,
                                            const Expectation::Signals& signals) {
  const auto solved = continuity.is_known() ? solve_anew(j.instant) : solve_declared(j.instant);
  if (!solved) return false;
  MonitoredInstant other{kept(*solved)};
  other.solved_anew = true;
  assess(other, signals, {}, false);
  if (other.assessment.singular) return false;
  ++corrected;
  j = other;
  return true;
}

/// Goes to the first instant from the nominal position. Where that leads elsewhere, the instant is
/// what it leads to.
void AccuracyMonitor::State::declare(MonitoredInstant& j) {
  if (!has(Monitor::orientation) || !has(Monitor::continuation)) return;
  NominalContinuation way(model, assessor);
  is_declared = way.begin() && way.go_to(continuity.driven(j.instant));
  if (!is_declared) return;
  declared.assign(way.q().begin(), way.q().end());
  if (way.leads_to(j.instant.q)) return;
  j.instant = kept(*solve_declared(j.instant));
  j.solved_anew = true;
  ++corrected;
}

/// Solves the first instant from where the nominal position leads.
std::optional<Instant> AccuracyMonitor::State::solve_declared(const Instant& instant) {
  if (!is_declared) return {};
  Instant there = instant;
  there.q = declared;
  return assessor.corrected(continuity.driven(there));
}

/// Corrects positions that have hardly missed their tolerance, as in single precision.
std::optional<Instant> AccuracyMonitor::State::solve_alone(const Instant& instant) {
  MonitoredInstant j{continuity.driven(instant)};
  if (!started) declare(j);
  const Instant solved = j.solved_anew ? j.instant : assessor.corrected(j.instant);
  const Assessment a = assessor(solved, scales.with(solved));
  if (a.singular || exceeds(a.bound, limits.degraded)) return {};
  return solved;
}

std::optional<MonitoredInstant> AccuracyMonitor::State::pass(const Instant& singular) {
  if (!has(Monitor::passage)) return {};
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
PerLevel<double> AccuracyMonitor::State::difference(const Instant& a, const Instant& b) const {
  PerLevel<double> result{};
  const auto add = [&](Level level, std::span<const double> x, std::span<const double> y) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double scale = scales.current().of(model.entities[entity[i]].kind, level);
      if (asked[i] >= level && scale > 0)
        result[level] = std::max(result[level], std::abs(x[i] - y[i]) / scale);
    }
  };
  add(Level::position, a.q, b.q);
  add(Level::velocity, a.qd, b.qd);
  add(Level::acceleration, a.qdd, b.qdd);
  return result;
}

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
std::optional<MonitoredInstant> AccuracyMonitor::solve_again(const Instant& instant) {
  return state_->solve_again(instant);
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
const Scales& AccuracyMonitor::scales() const { return state_->scales.current(); }
long AccuracyMonitor::degraded() const { return state_->degradations.count(); }
std::optional<Degradation> AccuracyMonitor::first_degraded() const {
  return state_->degradations.first();
}

}  // namespace desmo
