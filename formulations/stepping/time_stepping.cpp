#include "formulations/stepping/time_stepping.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "formulations/stepping/continuation.h"
#include "formulations/stepping/diagnosis.h"
#include "formulations/stepping/sub_steps.h"

namespace desmo {

namespace {

double sum_of_tolerances(const std::vector<DefinedPart>& parts) {
  double norm = 0;
  for (const DefinedPart& part : parts) norm = std::hypot(norm, part.tolerance);
  return norm;
}

Summary summary_of(const PartSequence::Result& result, double t) {
  Summary summary;
  summary.status = result.status;
  summary.instants = summary.ok();
  summary.iterations = result.iterations;
  summary.updates = result.updates;
  summary.residual = std::sqrt(result.residual2);
  summary.time = t;
  return summary;
}

void clear_rates(State& state) {
  std::ranges::fill(state.qd, 0.0);
  std::ranges::fill(state.qdd, 0.0);
}

}  // namespace

TimeStepping::TimeStepping(const Model& m, std::vector<DefinedPart> parts, const Settings& settings)
    : Formulation(m, settings, std::max(settings.tolerance, sum_of_tolerances(parts))),
      sequence_(m, std::move(parts)),
      drivers_(m) {
  for (State* s : {&state_, &before_})
    for (std::vector<double>* values : {&s->q, &s->qd, &s->qdd}) values->resize(m.state_size());
  start_.resize(m.state_size());
  prepare();
}

void TimeStepping::prepare() {
  predict_ = StatePredictor(settings().guess, parts());
  drivers_ = DriverSource(model(), sequence_.drivers());
  wanted_.reset();
}

void TimeStepping::solve_only(std::span<const Level> needed) {
  sequence_.solve_only(needed);
  prepare();
}

void TimeStepping::forget() {
  sequence_.forget();
  now_ = then_ = {};  // nothing to predict from
}

// ---- A motion, the paper's Fig. 2a ----

Summary TimeStepping::run(const TimeGrid& grid, const Request& request, Observer& observer) {
  assembled_ = false;
  return take_steps(grid, request, observer);
}

std::optional<Summary> TimeStepping::run_on(const TimeGrid& grid, const Request& request,
                                            Observer& observer) {
  const Summary total = take_steps(grid, request, observer);
  return total.ok() ? std::optional(total) : std::nullopt;
}

Summary TimeStepping::take_steps(const TimeGrid& grid, const Request& request, Observer& observer) {
  Summary total;
  want(request, observer.lent_at_once() > 0);
  drivers_.expect(grid);
  for (int i = 0; i < grid.instants; ++i) {
    const double t = grid.time(i);
    const Summary step =
        assembled_ ? solve_or_sub_step(t, request.level) : assemble_alone(t, request.level);
    total.add(step);
    if (!step.ok()) return total;
    total.stopped = deliver(i, t, step, request.level, observer) == Flow::stop;
    if (total.stopped) break;
  }
  if (grid.instants > 0) sequence_.store(state_);  // all, whatever was wanted
  return total;
}

/// Leaves the last instant in before_. Until it is solved the rest of state_ is of the instant
/// before, and of no meaning. Sines of drivers take longest and wait for nothing: they come first.
Summary TimeStepping::solve_at(double t, Level level) {
  const StepHistory history{t - now_.time, now_.time - then_.time, now_.level, then_.level};
  std::swap(state_, before_);
  const MotionRow& row = drivers_.drive(t, state_);  // z, ż, z̈
  predict_(history, before_, state_, state_);
  sequence_.begin_step(history, row);
  const PartSequence::Result result = sequence_.solve_moving(state_, before_.q, level);  // in order
  Summary summary = summary_of(result, t);
  if (!summary.ok()) [[unlikely]] {
    find_culprit_of(result, summary);
    std::ranges::copy(before_.q, state_.q.begin());
  }
  then_ = summary.ok() ? now_ : Solved{};
  now_ = {t, summary.ok() ? std::optional(level) : std::nullopt};
  return summary;
}

/// Returns the summary of the whole step if sub-steps fail, too.
Summary TimeStepping::solve_or_sub_step(double t, Level level) {
  const Solved start = now_;
  Summary summary = solve_at(t, level);
  if (!summary.ok() && (start.level || drivers_.is_live()) && start.time != t) [[unlikely]]
    summary = sub_step(start.time, t, level, summary);
  return summary;
}

/// Goes from the last instant to time t in sub-steps, after a failure to get there at once.
Summary TimeStepping::sub_step(double from, double t, Level level, const Summary& at_once) {
  start_ = state_.q;
  Summary summary, total = at_once;
  const bool arrived = go_in_sub_steps(from, t, max_sub_steps_, [&](double to) {
    summary = solve_at(to, to == t ? level : Level::position);
    ++total.sub_steps;
    total.iterations += summary.iterations;
    total.updates += summary.updates;
    return summary.ok();
  });
  if (!arrived) {
    std::ranges::copy(start_, state_.q.begin());
    summary = at_once;
  } else {
    summary.iterations = total.iterations;
    summary.updates = total.updates;
  }
  summary.sub_steps = total.sub_steps;
  return summary;
}

/// Finds the group and the constraint that could not be solved, from the last positions of the
/// part.
void TimeStepping::find_culprit_of(const PartSequence::Result& result, Summary& summary) {
  const PartDefinition& failed = parts()[result.failed].definition;
  sequence_.restore(before_.q);
  drivers_.write_all(state_);
  if (drivers_.is_live()) {
    if (failed.groups.size() == 1) summary.group = failed.groups.front();
    return;
  }
  for (const int i : failed.unknowns) state_.q[i] = before_.q[i];
  const Culprit culprit = find_culprit(model(), failed.groups, state_.q, settings());
  summary.group = culprit.group;
  summary.constraint = culprit.constraint;
}

// ---- Single instants ----

Summary TimeStepping::step(double t, Level level) {
  want({});
  return assembled_ ? solve_or_sub_step(t, level) : assemble_alone(t, level);
}

Summary TimeStepping::step(const LiveRow& row, Level level, int max_sub_steps) {
  want({});
  const double start = now_.time;
  drivers_.hand_in(row, start, state_);
  max_sub_steps_ = max_sub_steps;
  const Summary summary =
      assembled_ ? solve_or_sub_step(row.time, level) : assemble_alone(row.time, level);
  max_sub_steps_ = unlimited;
  drivers_.hand_back();
  if (!summary.ok()) {
    forget();  // parts remember instants that are not to be gone on from
    now_.time = start;
  }
  return summary;
}

void TimeStepping::return_to(std::span<const double> q, double t) {
  std::ranges::copy(q, state_.q.begin());
  assembled_ = !q.empty();
  forget();
  now_.time = t;
}

Summary TimeStepping::assemble(double t, Level level) {
  want({});
  return assemble_alone(t, level);
}

Summary TimeStepping::assemble_alone(double t, Level level) {
  std::ranges::copy(model().estimate, state_.q.begin());
  std::ranges::copy(model().fixed_values, state_.q.begin() + model().coordinates());
  for (State* s : {&state_, &before_}) clear_rates(*s);
  std::ranges::copy(state_.q, before_.q.begin());
  forget();
  assembled_ = false;
  const PartSequence::Result constant = sequence_.solve_constant(state_, before_.q, level);
  Summary summary = summary_of(constant, t);
  if (!summary.ok()) {
    find_culprit_of(constant, summary);
    return summary;
  }
  before_ = state_;  // what is solved once is in both
  summary = solve_at(t, level);
  // The estimate may be far off: a fixed number of iterations is for steps.
  for (int i = 0; i < settings().max_iterations && summary.ok() &&
                  settings().fixed_iterations > 0 && summary.residual >= tolerance();
       ++i) {
    const Summary before = summary;
    now_ = then_ = {};
    summary = solve_at(t, level);
    summary.iterations += before.iterations;
    summary.updates += before.updates;
  }
  sequence_.end_assembly();
  assembled_ = summary.ok();
  return summary;
}

bool TimeStepping::start_at(std::span<const double> q, double t) {
  want({});
  for (State* s : {&state_, &before_}) {
    std::ranges::copy(q, s->q.begin());
    clear_rates(*s);
  }
  forget();
  const auto solve = [&](State& state, std::span<const double> last) {
    return sequence_.solve_positions(state, last);
  };
  assembled_ = continue_drivers_to(model(), t, state_, solve);
  if (!assembled_) return false;
  before_.q = state_.q;
  drivers_.drive(t, state_);  // whole turns
  assembled_ = sequence_.solve_positions(state_, before_.q);
  sequence_.end_assembly();
  return assembled_;
}

void TimeStepping::take(const State& solved, double t, Level level) {
  state_ = solved;
  forget();
  now_ = {t, level};
}

// ---- What is read of each instant ----

void TimeStepping::want(const Request& request, bool lent) {
  if (wanted_ && lent == wanted_->lent &&
      std::ranges::equal(request.coordinates, wanted_->coordinates))
    return;
  const std::vector<int> requested = requested_coordinates(request, model().coordinates());
  wanted_ = {{request.coordinates.begin(), request.coordinates.end()}, lent};
  std::vector<bool> observed(model().state_size(), false);
  std::vector<int> places(model().state_size(), -1);
  for (std::size_t n = 0; n < requested.size(); ++n) {
    observed[requested[n]] = !lent;
    if (lent) places[requested[n]] = static_cast<int>(n);
  }
  sequence_.bind(observed, places);
  output_ = OutputWriter(places, requested.size());  // of what is left
  for (std::size_t i = 0; i < places.size(); ++i) observed[i] = observed[i] || places[i] >= 0;
  drivers_.set_observed(observed);
}

Flow TimeStepping::deliver(int index, double t, const Summary& step, Level level,
                           Observer& observer) {
  Instant instant{.index = index,
                  .time = t,
                  .q = q(),
                  .qd = {},
                  .qdd = {},
                  .updates = step.updates,
                  .residual = step.residual};
  if (level >= Level::velocity) instant.qd = qd();
  if (level >= Level::acceleration) instant.qdd = qdd();
  if (wanted_->lent) {
    observer.lend({&index, 1}, {&instant.output, 1});
    sequence_.deliver(instant.output, level);
    output_.write(instant);
  }
  return observer.observe(instant);
}

}  // namespace desmo
