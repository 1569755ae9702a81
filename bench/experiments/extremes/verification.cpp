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
std::string unflagged(const KnownCase& p, const CaseRun& a) {
  if (p.definition->is_refused) return {};
  for (std::size_t i = 0; i < a.steps.size(); ++i)
    if (a.steps[i].flag == Flag::none && !p.solvable[i])
      return "plain numbers " + instant_text(p, i) + ", where there is no answer";
  return {};
}

/// Returns whether conditioning explains that an instant is not proven: its stated radii are at
/// most max_over_floor times the floors of one of the answers. An instant that is not compared is
/// excused.
bool is_excused(const KnownCase& p, const CaseRun& a, std::size_t instant) {
  constexpr double max_over_floor = 1000;
  const auto found = std::ranges::lower_bound(p.compared, static_cast<int>(instant));
  if (found == p.compared.end() || *found != static_cast<int>(instant)) return true;
  const std::size_t next = found - p.compared.begin();
  return std::ranges::any_of(p.answers, [&](const Answers& of_part) {
    return std::ranges::all_of(all_levels, [&](Level l) {
      return a.stated[next]->radius[l] <= max_over_floor * of_part.floor[next][l];
    });
  });
}

/// Returns whether a compared instant up to this one is so near to a singular position that the
/// branch after it may be doubted.
bool is_near_singular(const KnownCase& p, const CaseRun& a, std::size_t instant) {
  constexpr double near = 1e6;  // smallest condition number (≥) near a singular position
  for (std::size_t n = 0; n < a.stated.size() && p.compared[n] <= static_cast<int>(instant); ++n)
    if (a.stated[n] && a.stated[n]->condition >= near) return true;
  return false;
}

/// Returns the first flag or failure for which there is no reason, in words; empty: there is none.
std::string needless_flag(const KnownCase& p, const CaseRun& a) {
  if (p.definition->may_fail) return {};
  bool has_reopened = false;  // an instant before has no answer, so that the branch is unknown
  for (std::size_t i = 0; i < a.steps.size(); ++i) {
    const Flag flag = a.steps[i].flag;
    has_reopened = has_reopened || !p.solvable[i];
    if (has_reopened && flag == Flag::other_branch) continue;
    if (p.solvable[i] && flag != Flag::none && !(flag == Flag::unproven && is_excused(p, a, i)) &&
        !(flag == Flag::other_branch && is_near_singular(p, a, i)))
      return a.message.empty() ? "failed " + instant_text(p, i) : a.message;
  }
  return {};
}

/// Returns the first step whose iterations differ by more than 1 from those of the row's first
/// case, in words; empty: there is none. Steps for which the first case needs no iterations do not
/// count: closed forms take none, but in extreme units a pivoting part may solve in their place.
std::string other_iterations(const CaseRun& a, const CaseRun& first) {
  for (std::size_t i = 0; i < std::min(a.steps.size(), first.steps.size()); ++i)
    if (first.steps[i].iterations > 0 &&
        std::abs(a.steps[i].iterations - first.steps[i].iterations) > 1)
      return formatted("%g iterations where the first case has %g", a.steps[i].iterations,
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
std::string overstated(const KnownCase& p, const CaseRun& a) {
  const double condition = p.condition();
  if (!(a.max.condition <= max_factor * condition))
    return formatted("condition %.1e said to be %.1e", condition, a.max.condition);
  double allowed =
      p.definition->factor * std::max(p.definition->scene.tolerance, std::ldexp(condition, -53));
  for (const Level level : all_levels) {
    if (!(a.max.radius[level] <= allowed))
      return formatted("%s said to be wrong by up to %.1e, more than %.1e", level_names[level],
                       a.max.radius[level], allowed);
    allowed *= std::max(condition, 1.0);
  }
  return {};
}

/// Returns the first end of a run's gaps that is off the known one by more than `bracket`, in
/// words; or else that their numbers differ. Empty: all ends are right.
std::string wrong_end(const KnownCase& p, const CaseRun& a) {
  constexpr double bracket = 1e-9;  // [s] (≤)
  std::vector<double> found;
  for (const Gap& gap : a.gaps) {
    found.push_back(gap.from);
    if (gap.ends) found.push_back(gap.to);
  }
  for (std::size_t i = 0; i < std::min(found.size(), p.ends.size()); ++i)
    if (!(std::abs(found[i] - p.ends[i]) <= bracket))
      return formatted("it says %.12g s where the answer ends or begins at %.12g s", found[i],
                       p.ends[i]);
  return found.size() == p.ends.size()
             ? ""
             : formatted("it says %zu ends of answers of %zu", found.size(), p.ends.size());
}

bool is_idle(const ModellingResult& modelled, const std::string& body) {
  return std::ranges::count(modelled.idle, body, &IdleFreedom::body) > 0;
}

/// Returns what was expected and is missing, although no number is wrong; empty: nothing is.
std::string shortcoming(const KnownCase& p, const CaseRun& a, const CaseRun* yardstick) {
  const ExtremeCase& c = *p.definition;
  if (c.bound == Bound::first_case && yardstick)
    if (std::string why = other_iterations(a, *yardstick); !why.empty()) return why;
  if (c.bound == Bound::estimates)
    if (std::string why = overstated(p, a); !why.empty()) return why;
  if (!c.failing_body.empty() && !is_named(p.modelled->model, a.failed_group, c.failing_body))
    return "it does not name the group of " + c.failing_body;
  if (c.is_redundant && p.modelled->left_out.empty()) return "it does not report the redundancy";
  if (c.past_failures)
    if (std::string why = wrong_end(p, a); !why.empty()) return why;
  if (!c.idle_body.empty() && !is_idle(*p.modelled, c.idle_body))
    return "it does not report that " + c.idle_body + " may spin";
  if (a.heap_growth > max_growth)
    return formatted("the heap has grown by %lld bytes", static_cast<long long>(a.heap_growth));
  return {};
}

}  // namespace

Verification verify(const KnownCase& p, const CaseRun& a, const CaseRun* yardstick) {
  const ExtremeCase& c = *p.definition;
  Verification j;
  j.outcome = a.outcome();
  const auto end = [&](ExtremeVerdict verdict, std::string reason) {
    j.verdict = verdict;
    j.reason = std::move(reason);
    return j;
  };
  if (j.outcome == CaseOutcome::not_applicable)
    return end(ExtremeVerdict::not_applicable, a.message);
  if (j.outcome == CaseOutcome::refused)
    return c.is_refused ? j : end(ExtremeVerdict::missed, a.message);
  if (!p.no_answer.empty()) {
    j.outcome = CaseOutcome::not_applicable;
    return end(ExtremeVerdict::not_applicable, "nothing to compare with: " + p.no_answer);
  }
  if (c.is_refused)
    return j.outcome == CaseOutcome::failed && a.steps.size() == 1
               ? j
               : end(ExtremeVerdict::defect, "numbers for what is no mechanism");
  const WorstErrors errors = errors_of(p, a, yardstick);
  j.worst = errors.worst;
  // The first that applies decides; they are sorted by gravity.
  for (auto& [why, verdict] : {std::pair{errors.defect, ExtremeVerdict::defect},
                               {unflagged(p, a), ExtremeVerdict::defect},
                               {needless_flag(p, a), ExtremeVerdict::missed},
                               {errors.inexact, ExtremeVerdict::missed},
                               {shortcoming(p, a, yardstick), ExtremeVerdict::missed}})
    if (!why.empty()) return end(verdict, why);
  return j;
}

}  // namespace desmo::extremes
