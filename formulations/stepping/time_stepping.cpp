#include "formulations/stepping/time_stepping.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "formulations/stepping/diagnosis.h"
#include "formulations/stepping/driver_continuation.h"
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
    : SegmentSolver(m, settings, std::max(settings.tolerance, sum_of_tolerances(parts))),
      sequence_(m, std::move(parts)),
      drivers_(m) {
  for (State* s : {&now_.state, &before_.state})
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
  for (SolvedState* s : {&now_, &before_}) s->forget();
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
    const Summary step = assemble_or_step(t, request.level);
    total.add(step);
    if (!step.ok()) return total;
    total.stopped = deliver(i, t, step, request.level, observer) == Flow::stop;
    if (total.stopped) break;
  }
  if (grid.instants > 0) sequence_.store(now_.state);  // all, whatever was wanted
  return total;
}

/// Leaves the last instant in before_. Sines of drivers take longest and wait for nothing: they
/// come first. Until it is predicted now_ holds the instant before the last one.
Summary TimeStepping::solve_at(double t, Level level) {
  const StepHistory history{t - now_.time, now_.time - before_.time, now_.level, before_.level};
  std::swap(now_, before_);
  State& state = now_.state;
  const State& last = before_.state;
  const MotionRow& row = drivers_.sample(t, state);  // z, ż, z̈
  predict_(history, last, state, state);
  sequence_.begin_step(history, row);
  const PartSequence::Result result = sequence_.solve_moving(state, last.q, level);  // in order
  Summary summary = summary_of(result, t);
  now_.time = t;
  now_.level = level;
  if (!summary.ok()) [[unlikely]] {
    sequence_.restore(before_.state.q);
    note_failure(result.failed);
    std::ranges::copy(last.q, state.q.begin());
    now_.level.reset();
    before_.forget();
    is_continued_ = false;
  }
  return summary;
}

/// Solves an instant, in sub-steps where it cannot be solved at once. Returns the summary of the
/// whole step if sub-steps fail, too.
Summary TimeStepping::assemble_or_step(double t, Level level, int max_sub_steps) {
  if (!assembled_) return assemble_alone(t, level);
  const double start = now_.time;
  const bool is_known = now_.level || is_continued_ || drivers_.is_live();
  failure_.part = -1;
  Summary summary = solve_at(t, level);
  if (!summary.ok() && is_known && start != t) [[unlikely]]
    summary = sub_step(start, t, level, max_sub_steps, summary);
  if (!summary.ok()) [[unlikely]]
    find_culprit_of_failure(summary);
  return summary;
}

/// Goes from the last instant to time t in sub-steps, after a failure to get there at once. total:
/// the summary of that failure.
Summary TimeStepping::sub_step(double from, double t, Level level, int max_sub_steps,
                               Summary total) {
  start_ = now_.state.q;
  Summary last = total;
  const bool arrived = go_in_sub_steps(from, t, max_sub_steps, [&](double to) {
    last = solve_at(to, to == t ? level : Level::position);
    ++total.sub_steps;
    total.iterations += last.iterations;
    total.updates += last.updates;
    return last.ok();
  });
  if (!arrived) {
    std::ranges::copy(start_, now_.state.q.begin());
    return total;
  }
  last.sub_steps = total.sub_steps;
  last.iterations = total.iterations;
  last.updates = total.updates;
  return last;
}

/// Keeps what a diagnosis of the first failure of a step needs, whatever sub-steps find.
void TimeStepping::note_failure(int part) {
  if (failure_.part >= 0) return;
  failure_.part = part;
  if (drivers_.is_live()) return;
  drivers_.write_all(now_.state);
  failure_.q = now_.state.q;
  for (const int i : parts()[part].definition.unknowns) failure_.q[i] = before_.state.q[i];
}

/// Finds the group and the constraint that could not be solved, from the last positions of the
/// part.
void TimeStepping::find_culprit_of_failure(Summary& summary) const {
  const PartDefinition& failed = parts()[failure_.part].definition;
  if (drivers_.is_live()) {
    if (failed.groups.size() == 1) summary.group = failed.groups.front();
    return;
  }
  const Culprit culprit = find_culprit(model(), failed.groups, failure_.q, settings());
  summary.group = culprit.group;
  summary.constraint = culprit.constraint;
}

// ---- Single instants ----

Summary TimeStepping::step_to(double t, Level level) {
  want({});
  return assemble_or_step(t, level);
}

Summary TimeStepping::step_to_row(const LiveRow& row, Level level, int max_sub_steps) {
  want({});
  const double start = now_.time;
  drivers_.hand_in(row, start, now_.state);
  const Summary summary = assemble_or_step(row.time, level, max_sub_steps);
  drivers_.hand_back();
  if (!summary.ok()) {
    forget();  // parts remember instants that are not to be gone on from
    now_.time = start;
  }
  return summary;
}

void TimeStepping::return_to(std::span<const double> q, double t) {
  std::ranges::copy(q.first(std::min(q.size(), now_.state.q.size())), now_.state.q.begin());
  assembled_ = !q.empty();
  forget();
  now_.time = t;
}

Summary TimeStepping::assemble_at(double t, Level level) {
  want({});
  return assemble_alone(t, level);
}

Summary TimeStepping::assemble_alone(double t, Level level) {
  State &state = now_.state, &last = before_.state;
  std::ranges::copy(model().estimate, state.q.begin());
  std::ranges::copy(model().fixed_values, state.q.begin() + model().coordinates());
  for (State* s : {&state, &last}) clear_rates(*s);
  std::ranges::copy(state.q, last.q.begin());
  forget();
  assembled_ = is_continued_ = false;
  failure_.part = -1;
  const PartSequence::Result constant = sequence_.solve_constant(state, last.q, level);
  Summary summary = summary_of(constant, t);
  if (!summary.ok()) {
    note_failure(constant.failed);
    find_culprit_of_failure(summary);
    return summary;
  }
  last = state;  // what is solved once is in both
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

bool TimeStepping::start_at(std::span<const double> q, double t) {
  want({});
  State &state = now_.state, &last = before_.state;
  for (State* s : {&state, &last}) {
    std::ranges::copy(q.first(std::min(q.size(), s->q.size())), s->q.begin());
    std::ranges::copy(model().fixed_values, s->q.begin() + model().coordinates());
    clear_rates(*s);
  }
  forget();
  const auto solve = [&](State& to, std::span<const double> from) {
    return sequence_.solve_positions(to, from);
  };
  assembled_ = continue_drivers_to(model(), t, state, solve);
  if (!assembled_) return false;
  now_.time = t;
  last.q = state.q;
  drivers_.sample(t, state);  // exactly, as a step samples them
  assembled_ = sequence_.solve_positions(state, last.q);
  sequence_.end_assembly();
  is_continued_ = assembled_;
  return assembled_;
}

void TimeStepping::take(const State& solved, double t, Level level) {
  now_.state = solved;
  forget();
  now_.time = t;
  now_.level = level;
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
