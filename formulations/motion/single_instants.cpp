// The instants that TimeStepping solves by themselves, and the first one of a motion.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "formulations/model/whole_turns.h"
#include "formulations/motion/driver_continuation.h"
#include "formulations/motion/time_stepping.h"

namespace desmo {

Summary TimeStepping::step(double t, Level level) {
  set_read_outside({});
  return assemble_or_step(t, level);
}

Summary TimeStepping::step_to_row(const LiveRow& row, Level level, int max_sub_steps) {
  set_read_outside({});
  const double start = now_.time;
  drivers_.hand_in(row, start, now_.state);
  const Summary summary = assemble_or_step(row.time, level, max_sub_steps);
  drivers_.hand_back();
  if (!summary.ok()) {
    forget_steps();  // parts remember instants from which no step may start
    now_.time = start;
  }
  return summary;
}

void TimeStepping::return_to(std::span<const double> q, double t) {
  std::ranges::copy(q.first(std::min(q.size(), now_.state.q.size())), now_.state.q.begin());
  assembled_ = !q.empty();
  forget_steps();
  now_.time = t;
}

Summary TimeStepping::assemble(double t, Level level) {
  set_read_outside({});
  return assemble_from_estimate(t, level);
}

/// Sets both instants to positions q, at rest; forgets what was solved.
void TimeStepping::begin_at(std::span<const double> q) {
  for (State* s : {&now_.state, &before_.state}) {
    std::ranges::copy(q.first(std::min(q.size(), s->q.size())), s->q.begin());
    std::ranges::copy(model().fixed_values, s->q.begin() + model().coordinates());
    std::ranges::fill(s->qd, 0.0);
    std::ranges::fill(s->qdd, 0.0);
  }
  forget();
}

Summary TimeStepping::assemble_from_estimate(double t, Level level) {
  State &state = now_.state, &last = before_.state;
  begin_at(model().estimate);
  assembled_ = false;
  failure_.part = -1;
  const PartSequence::Result constant = sequence_.solve_constant(state, last.q, level);
  Summary summary = constant.summary(t);
  if (!summary.ok()) {
    note_failure(constant.failed);
    find_culprit_of_failure(summary);
    return summary;
  }
  last = state;  // both instants have the constant parts, which are solved once
  const bool in_short_steps = assembles_in_short_steps_ && !is_drawn_at(t);
  if (in_short_steps || whole_turns_count(model())) {
    const ContinuationEnd end = continue_to(t, in_short_steps);
    if (end == ContinuationEnd::reached) {
      if (in_short_steps) take_nearest_turns();
      last.q = state.q;
    } else if (end == ContinuationEnd::too_long) {
      summary.status = Status::not_converged;
      summary.residual = NAN;
      summary.instants = 0;
      return summary;
    }
  }
  summary = solve_at(t, level);
  // The estimate may be far off: a fixed number of iterations is for steps.
  for (int i = 0; i < settings().max_iterations && summary.ok() &&
                  settings().fixed_iterations > 0 && summary.residual >= tolerance();
       ++i) {
    const Summary before = summary;
    for (SolvedState* s : {&now_, &before_}) s->forget();
    summary = solve_at(t, level);
    summary.iterations += before.iterations;
    summary.updates += before.updates;
  }
  sequence_.end_assembly();
  assembled_ = summary.ok();
  if (!assembled_) find_culprit_of_failure(summary);
  return summary;
}

/// Returns a state with the drivers at time t [s]. All else is that of the present one.
State TimeStepping::drivers_at(double t) {
  State to = now_.state;
  if (drivers_.is_live()) {
    drivers_.sample(t, to);
    drivers_.write_all(to);
  } else {
    write_drivers(model(), t, to);
  }
  return to;
}

/// Returns whether all drivers are at time t [s] where they are drawn, but for whole turns that do
/// not count.
bool TimeStepping::is_drawn_at(double t) {
  const std::vector<double> changes = driver_changes(model(), now_.state, drivers_at(t));
  return std::ranges::all_of(changes, [](double change) { return change == 0; });
}

/// Changes free angles by whole turns, to within half a turn of the drawing, as checked runs do.
void TimeStepping::take_nearest_turns() {
  constexpr double turn = 2 * std::numbers::pi;
  for (const int i : free_angles(model())) {
    double& angle = now_.state.q[i];
    angle -= turn * std::round((angle - model().estimate[i]) / turn);
  }
}

ContinuationEnd TimeStepping::continue_to(double t, bool in_short_steps) {
  const State start = now_.state, to = drivers_at(t);
  const auto solve = [&](State& state, std::span<const double> from) {
    return sequence_.solve_positions(state, from);
  };
  const ContinuationEnd end = continue_drivers_to(model(), to, now_.state, solve, in_short_steps);
  if (end != ContinuationEnd::reached) now_.state = start;
  return end;
}

bool TimeStepping::start_at(std::span<const double> q, double t) {
  set_read_outside({});
  State &state = now_.state, &last = before_.state;
  begin_at(q);
  assembled_ = continue_to(t) == ContinuationEnd::reached;
  if (!assembled_) return false;
  now_.time = t;
  last.q = state.q;
  drivers_.sample(t, state);  // the exact values, as in a step
  assembled_ = sequence_.solve_positions(state, last.q);
  sequence_.end_assembly();
  return assembled_;
}

}  // namespace desmo
