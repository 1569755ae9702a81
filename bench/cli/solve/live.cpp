// desmo solve --drivers: a scene whose drivers come row by row.
#include <algorithm>
#include <cstdio>

#include "bench/cli/errors.h"
#include "bench/cli/solve/check_notes.h"
#include "bench/cli/solve/driver_rows.h"
#include "bench/cli/solve/failure_notes.h"
#include "bench/cli/solve/task.h"
#include "bench/cli/text.h"
#include "cases/mechanism/formatted.h"
#include "formulations/verification/run/live_run.h"

namespace desmo::cli {
namespace {

std::string_view outcome_name(const LiveSummary& s) {
  if (s.fault != RowFault::none) return "refused";
  return s.outcome() == Outcome::converged  ? "converged"
         : s.outcome() == Outcome::degraded ? "degraded"
                                            : "failed";
}

/// Adds the summary of a row that was solved to `total`, the summary of the rows before it.
void add(const LiveSummary& s, const Scales& scales, CheckedSummary& total) {
  total.add(s);
  total.condition = std::max(total.condition, s.condition);
  total.scales = scales;
  if (s.flag) ++total.flagged;
  if (!total.first_flag) total.first_flag = s.flag;
  if (s.flag && s.flag->kind == RowFlag::Kind::unproven) return;
  for (const Level l : all_levels) total.radius[l] = std::max(total.radius[l], s.radius[l]);
}

std::string failure_of_row(const LiveSummary& s, const LiveRow& row, const LiveRun& run,
                           const Plan& plan, const DisplayUnits& units) {
  if (s.is_unreached() && s.status == Status::singular)
    return flag_text({.kind = RowFlag::Kind::branch,
                      .time = s.time,
                      .after = s.path.time,
                      .before = s.time,
                      .group = s.path.group,
                      .out_of_tests = s.path.out_of_tests},
                     plan.model, units) +
           (s.path.out_of_tests ? ", or keep away from singular positions, such as change points, "
                                  "near which tests run out"
                                : "; choose rows that keep away from it");
  CheckedSummary failure;
  static_cast<BasicSummary&>(failure) = s;
  failure.instants = run.has_position();
  const LiveRun::Obstacle obstacle = run.explain();
  if (s.status == Status::not_converged) failure.assembly_error = obstacle.assembly_error;
  failure.table_lock = obstacle.table_lock;
  if (obstacle.group >= 0) {
    failure.group = obstacle.group;
    failure.constraint = obstacle.constraint;
  }
  return failure_text(failure, plan.model, units, row.z);
}

/// Returns why a row was refused or failed or, in a strict run, is flagged.
std::string reason_of(const LiveSummary& s, const LiveRow& row, const LiveRun& run,
                      const Plan& plan, const DisplayUnits& units) {
  if (s.fault == RowFault::not_finite) return "a number is not finite; leave such rows out";
  if (s.fault == RowFault::time_not_later)
    return formatted(
        "t = %.9g s is not after the last row that was solved, t = %.9g s; let time go on", s.time,
        run.time());
  if (s.outcome() == Outcome::failed) return failure_of_row(s, row, run, plan, units);
  return flag_text(*s.flag, plan.model, units) +
         "; choose rows that avoid it, or solve without --strict";
}

}  // namespace

void solve_rows(const Task& task, Formulation& formulation) {
  const SolveOptions& o = task.options;
  if (const std::string reason = unsupported_live_reason(formulation); !reason.empty())
    throw CommandError(usage_error, "--drivers with " + task.heading.formulation + ": " + reason);
  if (o.check.mode != CheckMode::proof && o.check.mode != CheckMode::none)
    throw CommandError(usage_error,
                       "--check with --drivers: proof or none, for each row is "
                       "answered at once");
  const Plan& plan = task.plan;
  const DisplayUnits& units = task.input.units;
  LiveRun run(formulation, {.level = plan.level(), .levels = plan.levels, .check = o.check.mode});
  DriverRows rows(o.drivers, task.whole, plan.model, plan.level(), units);
  task.output.write(first_line(task.heading));
  CheckedSummary total;
  total.level = plan.level();
  long failed = 0;
  std::string text;
  for (LiveRow row{}; rows.next(row);) {
    const LiveSummary s = run.step(row);
    const bool is_solved = s.outcome() != Outcome::failed;
    const bool is_good = is_solved && !(o.check.strict && s.outcome() == Outcome::degraded);
    if (!is_good) {
      ++failed;
      const std::string what = rows.place() + ": " + reason_of(s, row, run, plan, units);
      if (!o.check.past_failures) {
        std::fputs(note_on_flags(total, plan.model, units).c_str(), stderr);
        throw CommandError(not_solved, task.input.source + ": " + what);
      }
      if (!o.quiet) std::fprintf(stderr, "note: %s\n", what.c_str());
    }
    text.clear();
    Instant instant{.index = 0, .time = row.time, .q = {}, .qd = {}, .qdd = {}};
    if (is_solved) instant.q = run.q(), instant.qd = run.qd(), instant.qdd = run.qdd();
    append_line(task.heading, task.measures.extend(instant), outcome_name(s), text);
    task.output.write(text);
    if (is_solved) add(s, run.scales(), total);
  }
  std::string note;
  if (total.instants > 0)
    note = o.quiet ? note_on_flags(total, plan.model, units)
                   : note_on_proofs(total, o.check, plan.model, units);
  if (failed > 0) note += "accuracy: not solved: " + count(failed, "row") + "\n";
  std::fputs(note.c_str(), stderr);
  task.output.finish();
}

}  // namespace desmo::cli
