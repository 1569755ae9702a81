#include "formulations/verification/run/checked_run.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "formulations/base/output_writer.h"
#include "formulations/motion/internals.h"
#include "formulations/verification/run/gap_search.h"
#include "formulations/verification/run/independent_motions.h"
#include "formulations/verification/run/row_tally.h"

namespace desmo {

namespace {

/// One checked run. As an observer of the formulation it checks instants and hands them on. It
/// stops the formulation's run where that is on another branch, and then goes on step by step.
class CheckedRun final : Observer {
  enum class From { estimate, last };

 public:
  CheckedRun(Formulation& formulation, const TimeGrid& grid, const Request& request,
             Observer& observer, const CheckOptions& options)
      : formulation_(formulation),
        grid_(grid),
        request_(request),
        options_(options),
        motion_(formulation.model(), options.levels, formulation.tolerance()),
        tally_(formulation.model(), grid),
        output_(request, formulation.model().coordinates()),
        next_(observer),
        copies_(options.mode == CheckMode::sample ? std::min(options.sample - 1, grid.instants) : 0,
                InstantCopy(formulation.model().coordinates())) {
    unchecked_.reserve(copies_.size());
    summary_.level = request.level;
  }

  CheckedSummary operator()() {
    motion_.begin(grid_.time(0));
    const Summary ran = formulation_.run(grid_, request_, *this);
    summary_.iterations = ran.iterations;
    const bool has_failed = !ran.stopped && !ran.ok() && hand_on_unchecked(true) == Flow::go_on;
    summary_.start = motion_.start();
    if (is_off_last_row_ || (has_failed && solve_after(ran))) go_on(From::last);
    for (explain_failure(); !summary_.ok() && options_.past_failures; explain_failure())
      if (pass_gap()) go_on(From::estimate);
    tally_.finish(summary_);
    return summary_;
  }

 private:
  Flow observe(const Instant& instant) noexcept override {
    if (is_between_samples(instant.index)) {
      keep(instant);
      return Flow::go_on;
    }
    const CheckedInstant& end = motion_.check(instant);
    const auto is_on_step = [&](const Instant& i) { return motion_.is_on_step(i); };
    const bool are_proven = unchecked_.empty() || (!end.flag && !end.is_elsewhere &&
                                                   std::ranges::all_of(unchecked_, is_on_step));
    // If something is wrong with the long step, its rows are checked one by one.
    if (!are_proven) motion_.return_to_last();
    const Flow flow = hand_on_unchecked(!are_proven);
    if (flow == Flow::stop) return flow;
    return hand_on(are_proven ? end : motion_.check(instant));
  }

  /// Returns whether an instant is not checked itself, but must lie on the step between two others.
  bool is_between_samples(int index) const {
    return options_.mode == CheckMode::sample && index % options_.sample != 0 &&
           index + 1 < grid_.instants;
  }

  /// Keeps a copy of an instant until a later one is checked.
  void keep(const Instant& instant) {
    InstantCopy& copy = copies_[unchecked_.size()];
    copy.assign({.values = {instant.q, instant.qd, instant.qdd}});
    unchecked_.push_back(with_values(instant, copy.view().values));
  }

  /// Hands on the unchecked rows: checked one by one now, or as they are.
  Flow hand_on_unchecked(bool are_checked) {
    Flow flow = Flow::go_on;
    for (const Instant& i : unchecked_)
      if (flow == Flow::go_on)
        flow = hand_on(are_checked ? motion_.check(i) : CheckedInstant{.instant = i});
    unchecked_.clear();
    return flow;
  }

  /// Counts a row and hands it on, unless a strict run refuses it. Returns Flow::stop if it does,
  /// if the observer stops, or if the formulation must restart from the row.
  Flow hand_on(CheckedInstant row) {
    is_off_last_row_ = row.is_elsewhere;
    summary_.time = row.instant.time;
    tally_.take(row, summary_);
    summary_.refused = options_.strict && row.flag;
    if (summary_.refused) return Flow::stop;
    summary_.condition = std::max(summary_.condition, row.condition);
    summary_.updates += row.instant.updates;
    summary_.residual = std::max(summary_.residual, row.instant.residual);
    if (options_.checked) options_.checked(row);
    if (is_off_last_row_) last_.assign(row.instant.q.begin(), row.instant.q.end());
    const Flow flow = output_.hand_over(row.instant, next_);
    ++summary_.instants;
    next_index_ = row.instant.index + 1;
    summary_.stopped = flow == Flow::stop;
    return is_off_last_row_ ? Flow::stop : flow;
  }

  void take_failure(const Summary& failed) {
    summary_.status = failed.status;
    summary_.group = failed.group;
    summary_.constraint = failed.constraint;
    max_residual_ = std::exchange(summary_.residual, failed.residual);
    summary_.time = grid_.time(next_index_);
  }
  void withdraw_failure() {
    summary_.status = Status::solved;
    summary_.group = summary_.constraint = no_position;
    summary_.residual = max_residual_;
    summary_.assembly_error.reset();
    summary_.table_lock.reset();
  }

  /// Returns a row with the formulation's present numbers, at the levels that are requested.
  Instant row(int index) const {
    const Formulation& f = formulation_;
    Instant at = instant_of(grid_.time(index), {f.q(), f.qd(), f.qdd()}, request_.level);
    at.index = index;
    return at;
  }

  /// Solves an instant by the path alone, where the formulation could not. Returns whether that
  /// succeeds.
  bool solve_by_path(int index) {
    const CheckedInstant* const found = motion_.solve(row(index));
    if (!found) return false;
    withdraw_failure();
    hand_on(*found);
    return true;
  }

  /// Solves the next row by the path alone, after the formulation's run failed. With a stride, that
  /// may be the failure of a later row: steps then tell how this one fails. Returns whether steps
  /// are to go on.
  bool solve_after(const Summary& failed) {
    take_failure(failed);
    if (solve_by_path(next_index_)) return true;
    if (failed.time == summary_.time) return false;
    withdraw_failure();
    return true;
  }

  /// Solves all remaining rows by steps, none by interpolation: the motion was hard to follow.
  /// - from: what the first row starts from, the estimate (assembly) or the last row (a step)
  void go_on(From from) {
    const auto next = [&] { return next_index_ + static_cast<int>(unchecked_.size()); };
    while (next() < grid_.instants && summary_.ok() && !summary_.refused && !summary_.stopped) {
      if (std::exchange(is_off_last_row_, false))
        stepping_of(formulation_).start_at(last_, summary_.time);  // where the last row is
      const int index = next();
      const bool is_step = std::exchange(from, From::last) == From::last;
      const Summary s = is_step ? formulation_.step(grid_.time(index), request_.level)
                                : formulation_.assemble(grid_.time(index), request_.level);
      summary_.iterations += s.iterations;
      if (s.ok()) {
        Instant solved = row(index);
        solved.updates = s.updates, solved.residual = s.residual;
        observe(solved);
      } else if (hand_on_unchecked(true) == Flow::go_on) {
        take_failure(s);
        if (!solve_by_path(index)) return;
      }
    }
  }

  /// Writes to the summary what explains a failure: a table's extremum, or the assembly error.
  void explain_failure() {
    if (summary_.status == Status::not_finite)
      summary_.table_lock =
          find_table_lock(formulation_.model(), summary_.constraint, motion_.followed_to());
    if (summary_.status == Status::not_converged)
      summary_.assembly_error = assembly_error_at(formulation_, summary_.time);
  }

  /// Goes from the instant that failed to the first that can be assembled again. Returns whether
  /// there is one.
  bool pass_gap() {
    const auto leads_to = [&](int index) {
      if (!motion_.try_again(row(index))) return false;
      const std::vector<double> q = motion_.followed_to();  // empty: one rests on a change point
      return !q.empty() && stepping_of(formulation_).start_at(q, grid_.time(index));
    };
    const auto [gap, again] = find_gap(formulation_, grid_, next_index_, summary_, leads_to);
    summary_.gaps.push_back(gap);
    withdraw_failure();
    next_index_ = again;
    if (again == grid_.instants) return false;
    motion_.begin_again(grid_.time(again));
    return true;
  }

  Formulation& formulation_;
  const TimeGrid grid_;
  const Request request_;
  const CheckOptions options_;
  IndependentMotions motion_;
  RowTally tally_;
  const OutputWriter output_;
  Observer& next_;
  std::vector<InstantCopy> copies_;  // of the unchecked rows
  std::vector<Instant> unchecked_;   // CheckMode::sample: rows since the last one that was checked
  CheckedSummary summary_;
  double max_residual_ = 0;       // of the rows, kept while summary_.residual is that of a failure
  int next_index_ = 0;            // index of the next row: all before are handed on or left out
  bool is_off_last_row_ = false;  // the formulation is not where the last row is
  std::vector<double> last_;      // positions of that row
};

}  // namespace

CheckedSummary run_checked(Formulation& formulation, const TimeGrid& grid, const Request& request,
                           Observer& observer, const CheckOptions& options) {
  if (!request.coordinates.empty())
    throw std::invalid_argument("a checked run needs all coordinates; the request names some");
  if (!options.levels.empty() && std::ssize(options.levels) != formulation.model().coordinates())
    throw std::invalid_argument("a checked run is not given one level for each coordinate");
  if (options.mode == CheckMode::sample && options.sample < 1)
    throw std::invalid_argument("a checked run is told to check every " +
                                std::to_string(options.sample) + "th row");
  if (options.mode != CheckMode::none) require_natural(formulation.model());
  if (!options.levels.empty()) formulation.solve_only(options.levels);
  if (options.mode == CheckMode::none) {
    stepping_of(formulation).assemble_in_short_steps();
    CheckedSummary summary;
    static_cast<BasicSummary&>(summary) = formulation.run(grid, request, observer);
    if (summary.status == Status::not_converged)
      summary.assembly_error = assembly_error_at(formulation, summary.time);
    return summary;
  }
  return CheckedRun(formulation, grid, request, observer, options)();
}

}  // namespace desmo
