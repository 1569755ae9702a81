// Instants at which the equations kept are poor, and others are not.
#include <utility>

#include "formulations/verification/assessment/chosen_equations.h"
#include "formulations/verification/monitor/accuracy_state.h"

namespace desmo {

AccuracyMonitor::State::State(const State& before, std::unique_ptr<const Model> other)
    : given(before.given),
      chosen(std::move(other)),
      model(chosen ? *chosen : given),
      options(before.options),
      has_others(true),
      limits(before.limits),
      assessor(model, options.levels, options.asked, norm()),
      asked(before.asked),
      measured(model, assessor.system(), assessor.levels(), asked),
      scales(before.scales),
      sensitivity(model, assessor.levels(), assessor.system().magnitudes()),
      conditioning(model, assessor.system(), assessor.row_magnitudes()),
      continuity(before.continuity),
      backward_error(model, assessor.system().equations(), assessor.levels()),
      signs(model, assessor.system()),
      entity(before.entity),
      weights(before.weights),
      max_weight_ratio(before.max_weight_ratio),
      improved(before.improved),
      last_time(before.last_time),
      started(before.continuity.is_known()),
      is_doubted(before.is_doubted),
      condition(before.condition),
      worst(before.worst),
      worst_before(before.worst_before),
      degradations(before.degradations),
      assessed(before.assessed),
      corrected(before.corrected) {}

/// Whether the equations kept may be to blame for what is said of an instant. It is not yet
/// delivered.
bool AccuracyMonitor::State::is_poor(const MonitoredInstant& j) const {
  return has_others && !j.instant.interpolated &&
         (j.assessment.singular || j.crossing ||
          (j.degraded && j.assessment.limit == Limit::singular_position));
}

/// Returns a state that goes on from the last instant, with equations chosen at positions q. Null:
/// there are no better ones, or the last instant is not on the branch of the one before it.
std::unique_ptr<AccuracyMonitor::State> AccuracyMonitor::State::with_equations_at(
    std::span<const double> q, const Instant& like) {
  if (!has_others) return {};
  auto model_there = with_chosen_equations(model, q);
  if (!model_there) return {};
  if (continuity.is_known()) {
    assessor(view_of(continuity.recent()[0], like), scales.current());
    if (signs.changed_block() >= 0) return {};
  }
  auto other = std::make_unique<State>(*this, std::move(model_there));
  if (other->started && !other->begin_at_last(like)) return {};
  return other;
}

/// Assesses the last instant, to compare others with. Returns whether it is regular.
bool AccuracyMonitor::State::begin_at_last(const Instant& like) {
  const Instant from = view_of(continuity.recent()[0], like);
  last = assessor(from, scales.current());
  ++assessed;
  if (last.singular) return false;
  sensitivity.growth(from);
  sensitivity.reset(from, assessor.system());
  conditioning.reset(from, assessor.system(), sensitivity.weights());
  backward_error.take_row_sums(assessor.system());
  signs.begin();
  degraded = true;  // so the next is assessed
  return true;
}

/// Returns the positions to which Taylor's polynomial leads from the last instant, if there is one.
std::vector<double> AccuracyMonitor::State::expected_positions(const Instant& instant) {
  if (!continuity.is_known()) return {instant.q.begin(), instant.q.end()};
  const RecentInstants::Node& last_one = continuity.recent()[0];
  const desmo::State& values = last_one.state;
  const double h = instant.time - last_one.time;
  std::vector<double> q = values.q;
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (!instant.qd.empty()) q[i] += h * values.qd[i];
    if (!instant.qdd.empty()) q[i] += h * h / 2 * values.qdd[i];
  }
  return q;
}

/// Returns a state with the equations given, where they are good enough again at the last instant.
std::unique_ptr<AccuracyMonitor::State> AccuracyMonitor::State::with_equations_given(
    const Instant& like) const {
  if (!chosen || !continuity.is_known()) return {};
  auto other = std::make_unique<State>(*this, nullptr);
  if (!other->begin_at_last(like)) return {};
  if (exceeds(other->last.bound, limits.degraded)) {
    // Where rounding makes the equations contradict each other, its position is not theirs.
    const Instant own = other->assessor.corrected(view_of(other->continuity.recent()[0], like));
    other->last = other->assessor(own, scales.current());
    if (other->last.singular || exceeds(other->last.bound, limits.degraded)) return {};
  }
  return other;
}

MonitoredInstant AccuracyMonitor::examine(const Instant& instant) {
  if (state_->chosen)
    if (auto other = state_->with_equations_given(instant)) state_ = std::move(other);
  MonitoredInstant j = state_->examine(instant);
  if (!state_->is_poor(j))
    state_->no_better = false;
  else if (state_->no_better || !examine_with_others(j, instant))
    if (!j.assessment.singular) state_->deliver(j, true);
  return j;
}

/// Examines a poor instant again with other equations. Returns whether these are better.
bool AccuracyMonitor::examine_with_others(MonitoredInstant& j, const Instant& instant) {
  state_->no_better = true;
  auto other = state_->with_equations_at(j.instant.q, instant);
  if (!other) return false;
  const MonitoredInstant k = other->examine(instant);
  if (other->is_poor(k)) return false;
  state_ = std::move(other);
  j = k;
  return true;
}

std::optional<MonitoredInstant> AccuracyMonitor::solve(const Instant& instant) {
  if (auto other = state_->with_equations_given(instant)) state_ = std::move(other);
  const auto j = state_->solve(instant);
  if (j && !state_->is_poor(*j)) return j;
  if (auto other = state_->with_equations_at(state_->expected_positions(instant), instant)) {
    const auto k = other->solve(instant);
    if (k && !other->is_poor(*k)) {
      state_ = std::move(other);
      return k;
    }
  }
  if (j) state_->deliver(*j, true);
  return j;
}

std::optional<MonitoredInstant> AccuracyMonitor::solve_again(const Instant& instant) {
  state_->take_back(instant);
  if (!state_->continuity.is_known()) return {};
  const auto solved = solve(instant);
  return solved ? solved : pass(instant);
}

}  // namespace desmo
