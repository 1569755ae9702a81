#include "formulations/verification/monitor/accuracy_monitor.h"

#include <algorithm>
#include <cmath>

#include "formulations/verification/assessment/chosen_equations.h"
#include "formulations/verification/monitor/accuracy_state.h"

namespace desmo {

namespace {

/// Instants from one look at the scales to the next: they grow slowly, and small ones are safe.
constexpr int look_every = 64;

}  // namespace

AccuracyMonitor::State::State(const Model& m, const TimeGrid& grid, const AccuracyMonitorOptions& o)
    : given(m),
      model(m),
      options(o),
      has_others(has(Monitor::redundancy) && o.may_allocate && has_other_equations(m)),
      limits(o.tolerance),
      assessor(m, o.levels, o.asked, norm()),
      asked(o.asked.empty() ? assessor.levels().begin() : o.asked.begin(),
            o.asked.empty() ? assessor.levels().end() : o.asked.end()),
      measured(m, assessor.system(), assessor.levels(), asked),
      scales(m, grid, o.scales, has(Monitor::scales)),
      sensitivity(m, assessor.levels(), assessor.system().magnitudes()),
      conditioning(m, assessor.system(), assessor.row_magnitudes()),
      continuity(m, grid, assessor.system().magnitudes(), o.max_steps),
      backward_error(m, assessor.system().equations(), assessor.levels()),
      signs(m, assessor.system()),
      entity(entity_of_coordinate(m)),
      degradations(limits.degraded, o.max_degradations) {
  for (std::vector<double>* values : {&improved.q, &improved.qd, &improved.qdd})
    values->reserve(m.coordinates());
}

MonitoredInstant AccuracyMonitor::State::examine(const Instant& given) {
  MonitoredInstant j{given};
  if (model.coordinates() == 0) return j;  // all is fixed: nothing can be wrong
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
  const bool was_degraded = degraded, known_before = rates_are_known(),
             from_noise = was_degraded && !known_before;
  // Accelerations that are noise raise doubts; where velocities are known, shorter steps settle
  // them.
  const bool is_blind =
      in_doubt && degraded && exceeds(last.bound, {unusable_rate, unusable_rate, INFINITY});
  if (in_doubt && !instant.interpolated) jump = find_jump(j, from_noise);
  // A doubt remains one even where shorter steps agree: next to where solutions meet, they too
  // may end on another branch.
  const bool is_assessed = in_doubt || !statement.holds || is_due(signals);
  if (is_assessed)
    assess(j, signals, in_doubt);
  else
    j.assessment = statement.assessment;
  if (j.assessment.singular && !instant.interpolated && has(Monitor::repair))
    solve_singular(j, signals);
  if (j.too_coarse) return j;
  if (j.crossing && !instant.interpolated && !was_degraded && has(Monitor::repair) &&
      options.may_allocate)
    solve_crossed(j, signals);
  // Nobody can tell where a doubtful step from rates that are noise leads.
  if (jump && (jump->at_turn || from_noise || (known_before && rates_are_known())))
    j.crossing = jump->crossing;
  else if (is_blind && continuity.is_known() && !j.crossing)
    j.crossing = {continuity.recent()[0].time, instant.time, last.group,
                  SingularityCrossing::Kind::jumped};
  if (j.assessment.singular || is_poor(j)) return j;  // which is not delivered
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
  worst_before = worst;
  add({j.instant.index, j.instant.time, j.assessment}, j.degraded);
}

void AccuracyMonitor::State::add(const Degradation& d, bool is_degraded) {
  for (const Level l : all_levels) worst[l] = std::max(worst[l], d.assessment.bound[l]);
  if (is_degraded) degradations.add(d);
}

AccuracyMonitor::AccuracyMonitor(const Model& m, const TimeGrid& grid,
                                 const AccuracyMonitorOptions& options)
    : state_(std::make_unique<State>(m, grid, options)) {}
AccuracyMonitor::~AccuracyMonitor() = default;

std::optional<MonitoredInstant> AccuracyMonitor::pass(const Instant& singular) {
  return state_->pass(singular);
}
AccuracyMonitor::Start AccuracyMonitor::last() const {
  if (!state_->beyond.q.empty()) return state_->beyond;
  const RecentInstants& recent = state_->continuity.recent();
  if (recent.count() == 0) return {};
  return {recent[0].state.q, recent[0].time};
}
void AccuracyMonitor::withdraw(const Instant& instant) {
  state_->degradations.take_back(instant.index);
  state_->worst = state_->worst_before;
}
void AccuracyMonitor::resume() {
  state_->after_gap = true;
  state_->continuity.forget();
}
void AccuracyMonitor::rest() { state_->continuity.rest(); }
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
