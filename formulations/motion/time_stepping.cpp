#include "formulations/motion/time_stepping.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "formulations/motion/diagnosis.h"
#include "formulations/motion/sub_steps.h"

namespace desmo {

namespace {

/// Returns the tolerance of the whole mechanism: ‖Φ‖₂ where each part's is at its tolerance.
double norm_of_tolerances(const std::vector<DefinedPart>& parts) {
  double norm = 0;
  for (const DefinedPart& part : parts) norm = std::hypot(norm, part.tolerance);
  return norm;
}

}  // namespace

TimeStepping::TimeStepping(const Model& m, std::vector<DefinedPart> parts, const Settings& settings,
                           std::unique_ptr<SegmentExecutor> executor)
    : Formulation(m, settings, std::max(settings.tolerance, norm_of_tolerances(parts))),
      sequence_(m, std::move(parts)),
      drivers_(m),
      executor_(std::move(executor)) {
  for (SolvedState* s : {&now_, &before_}) s->state.resize(m.state_size());
  start_.resize(m.state_size());
  prepare();
}

void TimeStepping::prepare() {
  predict_ = StatePredictor(settings().guess, parts());
  drivers_ = DriverSource(model(), sequence_.drivers());
  read_outside_.reset();
}

void TimeStepping::solve_only(std::span<const Level> needed) {
  if (std::ssize(needed) != model().coordinates())
    throw std::invalid_argument("there are " + std::to_string(needed.size()) + " levels for " +
                                std::to_string(model().coordinates()) + " coordinates");
  if (settings().stride > 1) return;  // interpolation needs all levels
  if (executor_) executor_->solve_only(needed);
  sequence_.solve_only(needed);
  prepare();
}

void TimeStepping::forget() {
  sequence_.forget();
  for (SolvedState* s : {&now_, &before_}) s->forget();
}

/// Forgets the steps so far, without beginning an assembly: what follows are steps again.
void TimeStepping::forget_steps() {
  forget();
  sequence_.end_assembly();
}

// ---- A motion, the paper's Fig. 2a ----

Summary TimeStepping::run(const TimeGrid& grid, const Request& request, Observer& observer) {
  return settings().stride > 1 ? run_with_stride(grid, request, observer)
                               : solve_all(grid, request, observer);
}

/// Solves every instant of a grid: in segments where there are any that meet, else step by step.
Summary TimeStepping::solve_all(const TimeGrid& grid, const Request& request, Observer& observer) {
  if (executor_ && grid.instants > 0) {
    if (assemble(grid.time(0), request.level).ok())
      if (const std::optional<Summary> total = solve_segments(grid, request, observer))
        return *total;
    ++runs_without_segments_;
  }
  assembled_ = false;
  return take_steps(grid, request, observer);
}

std::optional<Summary> TimeStepping::run_on(const TimeGrid& grid, const Request& request,
                                            Observer& observer) {
  if (executor_) return solve_segments(grid, request, observer);
  const Summary total = take_steps(grid, request, observer);
  return total.ok() ? std::optional(total) : std::nullopt;
}

Summary TimeStepping::take_steps(const TimeGrid& grid, const Request& request, Observer& observer) {
  Summary total;
  set_read_outside(request, observer.lent_at_once() > 0);
  drivers_.expect(grid);
  for (int i = 0; i < grid.instants; ++i) {
    const double t = grid.time(i);
    const Summary step = assemble_or_step(t, request.level);
    total.add(step);
    if (!step.ok()) return total;
    total.stopped = deliver(i, t, step, request.level, observer) == Flow::stop;
    if (total.stopped) break;
  }
  if (grid.instants > 0) sequence_.store(now_.state);  // all coordinates, whatever was requested
  return total;
}

/// Solves an instant from the prediction. Sines of drivers take longest and wait for nothing: they
/// come first. The swap makes before_ the last instant. now_ still holds the one before that, from
/// which the prediction is made in place.
Summary TimeStepping::solve_at(double t, Level level) {
  const StepHistory history{t - now_.time, now_.time - before_.time, now_.level, before_.level};
  std::swap(now_, before_);
  State& state = now_.state;
  const State& last = before_.state;
  const MotionRow& row = drivers_.sample(t, state);  // the drivers: z, ż, z̈
  predict_(history, last, state, state);
  sequence_.begin_step(history, row);
  // the parts in order
  const PartSequence::Result result = sequence_.solve_moving(state, last.q, level);
  Summary summary = result.summary(t);
  now_.time = t;
  now_.level = level;
  if (!summary.ok()) [[unlikely]] {
    sequence_.restore(before_.state.q);
    note_failure(result.failed);
    std::ranges::copy(last.q, state.q.begin());
    now_.level.reset();
    before_.forget();
  }
  return summary;
}

/// Solves an instant, in sub-steps where it cannot be solved at once. If these fail, too, returns
/// the summary of the first attempt, with the work of all.
Summary TimeStepping::assemble_or_step(double t, Level level, int max_sub_steps) {
  if (!assembled_) return assemble_from_estimate(t, level);
  const double start = now_.time;
  failure_.part = -1;
  Summary summary = solve_at(t, level);
  if (!summary.ok() && start != t) [[unlikely]]
    summary = sub_step(start, t, level, max_sub_steps, summary);
  if (!summary.ok()) [[unlikely]] {
    now_.time = start;  // that of the positions
    find_culprit_of_failure(summary);
  }
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

// ---- What is read of each instant ----

void TimeStepping::set_read_outside(const Request& request, bool lent) {
  if (read_outside_ && lent == read_outside_->lent &&
      std::ranges::equal(request.coordinates, read_outside_->coordinates))
    return;
  const std::vector<int> requested = requested_coordinates(request, model().coordinates());
  read_outside_ = {{request.coordinates.begin(), request.coordinates.end()}, lent};
  std::vector<bool> observed(model().state_size(), false);
  std::vector<int> places(model().state_size(), -1);
  for (std::size_t n = 0; n < requested.size(); ++n) {
    observed[requested[n]] = !lent;
    if (lent) places[requested[n]] = static_cast<int>(n);
  }
  sequence_.bind(observed, places);
  output_ = OutputWriter(places, requested.size());  // writes what no part delivers
  for (std::size_t i = 0; i < places.size(); ++i) observed[i] = observed[i] || places[i] >= 0;
  drivers_.set_observed(observed);
}

Flow TimeStepping::deliver(int index, double t, const Summary& step, Level level,
                           Observer& observer) {
  Instant instant = instant_of(t, {q(), qd(), qdd()}, level);
  instant.index = index;
  instant.updates = step.updates;
  instant.residual = step.residual;
  if (read_outside_->lent) {
    observer.lend({&index, 1}, {&instant.output, 1});
    sequence_.deliver(instant.output, level);
    output_.write(instant);
  }
  return observer.observe(instant);
}

}  // namespace desmo
