#include "bench/experiments/extremes/verification.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cases/mechanism/formatted.h"
#include "formulations/base/per_level.h"

namespace desmo::extremes {

namespace {

/// Bytes by which the heap may grow in a long run (≤): factors made anew are not always of one
/// size.
constexpr std::int64_t max_growth = 4096;

using Flag = CaseRun::Flag;

/// Returns the first instant that has unflagged numbers although it has no answer, in words; empty:
/// there is none.
std::string unflagged(const KnownCase& known, const CaseRun& run) {
  if (known.definition->is_refused) return {};
  for (std::size_t i = 0; i < run.steps.size(); ++i)
    if (run.steps[i].flag == Flag::none && !known.solvable[i])
      return "plain numbers " + instant_text(known, i) + ", where there is no answer";
  return {};
}

/// Returns whether conditioning explains that an instant is not proven: its stated radii are at
/// most max_over_floor times the floors of one of the answers. An instant that is not compared is
/// excused.
bool is_excused(const KnownCase& known, const CaseRun& run, std::size_t instant) {
  constexpr double max_over_floor = 1000;
  const auto found = std::ranges::lower_bound(known.compared, static_cast<int>(instant));
  if (found == known.compared.end() || *found != static_cast<int>(instant)) return true;
  const std::size_t next = found - known.compared.begin();
  return std::ranges::any_of(known.answers, [&](const Answers& of_part) {
    return std::ranges::all_of(all_levels, [&](Level l) {
      return run.stated[next]->radius[l] <= max_over_floor * of_part.floor[next][l];
    });
  });
}

/// Returns whether a compared instant up to this one is so near to a singular position that the
/// branch after it may be doubted.
bool is_near_singular(const KnownCase& known, const CaseRun& run, std::size_t instant) {
  constexpr double near = 1e6;  // smallest condition number (≥) near a singular position
  for (std::size_t n = 0; n < run.stated.size() && known.compared[n] <= static_cast<int>(instant);
       ++n)
    if (run.stated[n] && run.stated[n]->condition >= near) return true;
  return false;
}

/// Returns the first flag or failure for which there is no reason, in words; empty: there is none.
std::string needless_flag(const KnownCase& known, const CaseRun& run) {
  if (known.definition->may_fail) return {};
  bool has_reopened = false;  // an instant before has no answer, so that the branch is unknown
  for (std::size_t i = 0; i < run.steps.size(); ++i) {
    const Flag flag = run.steps[i].flag;
    has_reopened = has_reopened || !known.solvable[i];
    if (has_reopened && flag == Flag::other_branch) continue;
    if (known.solvable[i] && flag != Flag::none &&
        !(flag == Flag::unproven && is_excused(known, run, i)) &&
        !(flag == Flag::other_branch && is_near_singular(known, run, i)))
      return run.message.empty() ? "failed " + instant_text(known, i) : run.message;
  }
  return {};
}

/// Returns the first step whose iterations differ by more than 1 from those of the row's first
/// case, in words; empty: there is none. Steps for which the first case needs no iterations do not
/// count: closed forms take none, but in extreme units a pivoting part may solve in their place.
std::string other_iterations(const CaseRun& run, const CaseRun& first) {
  for (std::size_t i = 0; i < std::min(run.steps.size(), first.steps.size()); ++i)
    if (first.steps[i].iterations > 0 &&
        std::abs(run.steps[i].iterations - first.steps[i].iterations) > 1)
      return formatted("%g iterations where the first case has %g", run.steps[i].iterations,
                       first.steps[i].iterations);
  return {};
}

bool is_named(const Model& m, GroupId group, const std::string& body) {
  return group >= 0 && std::ranges::count(m.groups[group].bodies, body) > 0;
}

/// Largest ratio (≤) of the condition number that a run states, that of its worst block, to that of
/// the whole model.
constexpr double max_factor = 10;

/// Returns the first too large one of the condition number and radii that were stated for the whole
/// run, in words; empty: none is.
std::string overstated(const KnownCase& known, const CaseRun& run) {
  const double condition = known.condition();
  if (!(run.max.condition <= max_factor * condition))
    return formatted("condition %.1e said to be %.1e", condition, run.max.condition);
  double allowed = known.definition->factor *
                   std::max(known.definition->scene.tolerance, std::ldexp(condition, -53));
  for (const Level level : all_levels) {
    if (!(run.max.radius[level] <= allowed))
      return formatted("%s said to be wrong by up to %.1e, more than %.1e", level_names[level],
                       run.max.radius[level], allowed);
    allowed *= std::max(condition, 1.0);
  }
  return {};
}

/// Returns the first end of a run's gaps that is off the known one by more than `bracket`, in
/// words; or else that their numbers differ. Empty: all ends are right.
std::string wrong_end(const KnownCase& known, const CaseRun& run) {
  constexpr double bracket = 1e-9;  // [s] (≤)
  std::vector<double> found;
  for (const Gap& gap : run.gaps) {
    found.push_back(gap.from);
    if (gap.ends) found.push_back(gap.to);
  }
  for (std::size_t i = 0; i < std::min(found.size(), known.ends.size()); ++i)
    if (!(std::abs(found[i] - known.ends[i]) <= bracket))
      return formatted("it says %.12g s where the answer ends or begins at %.12g s", found[i],
                       known.ends[i]);
  return found.size() == known.ends.size()
             ? ""
             : formatted("it says %zu ends of answers of %zu", found.size(), known.ends.size());
}

bool is_idle(const ModellingResult& modelled, const std::string& body) {
  return std::ranges::count(modelled.idle, body, &IdleFreedom::body) > 0;
}

/// Returns what was expected and is missing, although no number is wrong; empty: nothing is.
std::string shortcoming(const KnownCase& known, const CaseRun& run, const CaseRun* yardstick) {
  const ExtremeCase& c = *known.definition;
  if (c.bound == Bound::first_case && yardstick)
    if (std::string why = other_iterations(run, *yardstick); !why.empty()) return why;
  if (c.bound == Bound::estimates)
    if (std::string why = overstated(known, run); !why.empty()) return why;
  if (!c.failing_body.empty() && !is_named(known.modelled->model, run.failed_group, c.failing_body))
    return "it does not name the group of " + c.failing_body;
  if (c.is_redundant && known.modelled->left_out.empty())
    return "it does not report the redundancy";
  if (c.past_failures)
    if (std::string why = wrong_end(known, run); !why.empty()) return why;
  if (!c.idle_body.empty() && !is_idle(*known.modelled, c.idle_body))
    return "it does not report that " + c.idle_body + " may spin";
  if (run.heap_growth > max_growth)
    return formatted("the heap has grown by %lld bytes", static_cast<long long>(run.heap_growth));
  return {};
}

}  // namespace

Verification verify(const KnownCase& known, const CaseRun& run, const CaseRun* yardstick) {
  const ExtremeCase& c = *known.definition;
  Verification result;
  result.outcome = run.outcome();
  const auto end = [&](ExtremeVerdict verdict, std::string reason) {
    result.verdict = verdict;
    result.reason = std::move(reason);
    return result;
  };
  if (result.outcome == CaseOutcome::not_applicable)
    return end(ExtremeVerdict::not_applicable, run.message);
  if (result.outcome == CaseOutcome::refused)
    return c.is_refused ? result : end(ExtremeVerdict::missed, run.message);
  if (!known.no_answer.empty()) {
    result.outcome = CaseOutcome::not_applicable;
    return end(ExtremeVerdict::not_applicable, "nothing to compare with: " + known.no_answer);
  }
  if (c.is_refused)
    return result.outcome == CaseOutcome::failed && run.steps.size() == 1
               ? result
               : end(ExtremeVerdict::defect, "numbers for what is no mechanism");
  const WorstErrors errors = errors_of(known, run, yardstick);
  result.worst = errors.worst;
  // The first that applies decides; they are sorted by gravity.
  for (auto& [why, verdict] : {std::pair{errors.defect, ExtremeVerdict::defect},
                               {unflagged(known, run), ExtremeVerdict::defect},
                               {needless_flag(known, run), ExtremeVerdict::missed},
                               {errors.inexact, ExtremeVerdict::missed},
                               {shortcoming(known, run, yardstick), ExtremeVerdict::missed}})
    if (!why.empty()) return end(verdict, why);
  return result;
}

}  // namespace desmo::extremes
