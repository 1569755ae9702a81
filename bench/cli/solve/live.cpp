#include "bench/cli/solve/live.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "bench/cli/errors.h"
#include "bench/cli/solve/driver_rows.h"
#include "bench/cli/solve/run_notes.h"
#include "bench/cli/text.h"
#include "cases/mechanism/formatted.h"
#include "formulations/verification/assessment/limits.h"
#include "formulations/verification/monitor/live_run.h"

namespace desmo::cli {
namespace {

std::string_view outcome_name(const LiveSummary& s) {
  if (s.fault != RowFault::none) return "refused";
  return s.outcome() == Outcome::converged  ? "converged"
         : s.outcome() == Outcome::degraded ? "degraded"
                                            : "failed";
}

/// The row and the rows before it, in the words of a motion known in advance.
MonitoredSummary as_motion(const LiveSummary& s) {
  MonitoredSummary motion;
  static_cast<BasicSummary&>(motion) = s;
  motion.condition = s.assessment.condition;
  motion.bound = s.assessment.bound;
  if (s.degraded) motion.first_degraded = Degradation{0, s.time, s.assessment};
  motion.crossing = s.first_crossing;
  motion.violated = s.violated;
  const Limit limit = s.assessment.limit;
  if (s.outcome() == Outcome::failed && limit != Limit::singular_position &&
      limit != Limit::rounding)
    motion.limit = limit;
  return motion;
}

std::string reason_of(const LiveSummary& s, const LiveRow& row, const LiveRun& run,
                      const Plan& plan, const DisplayUnits& units) {
  if (s.fault == RowFault::not_finite) return "a number is not finite; leave such rows out";
  if (s.fault == RowFault::time_not_later)
    return formatted(
        "t = %.9g s is not after the last row that was solved, t = %.9g s; let time go on", s.time,
        run.time());
  if (s.outcome() != Outcome::failed) return refusal_text(as_motion(s), plan.level(), plan.model);
  MonitoredSummary failure = as_motion(s);
  failure.instants = run.has_position();
  if (s.violated >= 0) return failure_text(failure, plan.model, units);
  const LiveRun::Obstacle obstacle = run.explain();
  if (s.status == Status::not_converged) failure.assembly_error = obstacle.assembly_error;
  if (obstacle.group >= 0) {
    failure.group = obstacle.group;
    failure.constraint = obstacle.constraint;
  }
  return failure_text(failure, plan.model, units, row.z);
}

}  // namespace

void solve_live(const LiveRequest& request, Formulation& formulation, const SeriesHeading& heading,
                const SeriesFormat& format, OutputFile& output) {
  const Plan& plan = request.plan;
  LiveOptions options{.level = plan.level(), .levels = plan.levels};
  options.assesses_all = request.strict;
  LiveRun run(formulation, options);
  DriverRows rows(request.drivers, request.whole, plan.model, plan.level(), request.units);
  output.write(format.heading(heading));
  MonitoredSummary total;
  long failed = 0;
  std::string text;
  for (LiveRow row{}; rows.next(row);) {
    const LiveSummary s = run.step(row);
    const bool is_solved = s.outcome() != Outcome::failed;
    const bool is_good = is_solved && !(request.strict && s.outcome() == Outcome::degraded);
    if (!is_good) {
      ++failed;
      const std::string what = rows.place() + ": " + reason_of(s, row, run, plan, request.units);
      if (!request.past_failures) {
        std::fputs(note_on_flags(total, plan.level(), plan.model).c_str(), stderr);
        throw CommandError(not_solved, request.source + ": " + what);
      }
      if (!request.quiet) std::fprintf(stderr, "note: %s\n", what.c_str());
    }
    text.clear();
    Instant instant{.index = 0, .time = row.time, .q = {}, .qd = {}, .qdd = {}};
    if (is_solved) instant.q = run.q(), instant.qd = run.qd(), instant.qdd = run.qdd();
    format.append(heading, instant, text, outcome_name(s));
    output.write(text);
    if (!is_solved) continue;
    const MonitoredSummary one = as_motion(s);
    total.add(s);
    total.condition = std::max(total.condition, one.condition);
    rescale(total.bound, std::exchange(total.scales, run.scales()), run.scales());
    for (const Level l : all_levels) total.bound[l] = std::max(total.bound[l], one.bound[l]);
    total.degraded += s.degraded;
    if (!total.first_degraded) total.first_degraded = one.first_degraded;
    if (!total.crossing) total.crossing = one.crossing;
  }
  std::string note;
  if (total.instants > 0)
    note = request.quiet ? note_on_flags(total, plan.level(), plan.model)
                         : note_on_accuracy(total, plan.level(), plan.model, request.units);
  if (failed > 0) note += "accuracy: not solved: " + count(failed, "row") + "\n";
  std::fputs(note.c_str(), stderr);
}

}  // namespace desmo::cli
