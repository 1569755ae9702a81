#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/experiments/extremes/verification.h"
#include "cases/mechanism/formatted.h"
#include "formulations/base/per_level.h"

namespace desmo::extremes {

namespace {

using Flag = CaseRun::Flag;

/// Returns the largest errors over all answers, at the first `count` compared instants.
PerLevel<double> max_errors(const CaseRun& run,
                            std::size_t count = std::numeric_limits<std::size_t>::max()) {
  PerLevel<double> worst;
  for (const auto& of_part : run.errors)
    for (std::size_t i = 0; i < std::min(count, of_part.size()); ++i)
      for (const Level level : all_levels)
        if (of_part[i]) worst[level] = std::max(worst[level], (*of_part[i])[level]);
  return worst;
}

/// Returns the errors that the case's bound multiplies: those of the first half for
/// Bound::first_part, else those of the yardstick; zeros without a yardstick.
PerLevel<double> measured(const KnownCase& known, const CaseRun& run, const CaseRun* yardstick) {
  if (known.definition->bound == Bound::first_part)
    return max_errors(run, known.compared.size() / 2);
  return yardstick ? max_errors(*yardstick) : PerLevel<double>{};
}

/// Returns the allowed relative error of answers `part` at the compared instant `next`, by the
/// case's bound (Bound). yardstick: the errors of measured().
double allowed_error(const KnownCase& known, const CaseRun& run, const PerLevel<double>& yardstick,
                     Level level, std::size_t part, std::size_t next) {
  const ExtremeCase& c = *known.definition;
  const Answers& answers = known.answers[part];
  const double floor = answers.floor[next][level];
  const bool is_position = level == Level::position;
  switch (c.bound) {
    case Bound::floor:
      return c.factor * floor;
    case Bound::length: {
      const double epsilon = std::numeric_limits<double>::epsilon();
      return (is_position ? c.factor * epsilon * answers.chain_length : 0) + 10 * floor;
    }
    case Bound::tolerance:
      return c.factor * std::max(c.scene.tolerance, floor);
    case Bound::fixed:
      return is_position ? c.factor : 10 * floor;
    case Bound::estimates:
      return run.stated[next] ? run.stated[next]->radius[level] : 0;
    case Bound::first_part:
      if (next < known.compared.size() / 2) return 10 * std::max(c.scene.tolerance, floor);
      [[fallthrough]];
    default:
      return std::max(c.factor * yardstick[level], floor);
  }
}

/// Returns whether an error exceeds the allowed one, ten times the tolerance and the floor, and the
/// bound that was stated with it: nothing excuses it.
bool is_wrong(const WorstError& e, double tolerance, double stated) {
  return e.error > std::max({e.allowed, 10 * std::max(tolerance, e.floor), stated});
}

/// Returns whether an error is worse than another: by its ratio to the error allowed or, where
/// neither is allowed any, by its size. Anything is worse than WorstError{}.
bool is_worse(const WorstError& e, const WorstError& other) {
  if (other.allowed == 0 && (e.allowed == 0 || other.error == 0)) return e.error >= other.error;
  return e.error * other.allowed > other.error * e.allowed;
}

}  // namespace

std::string instant_text(const KnownCase& known, std::size_t instant) {
  if (known.definition->starts) return formatted("from start %zu", instant + 1);
  return formatted("at t = %.9g s", known.definition->scene.grid.time(static_cast<int>(instant)));
}

WorstErrors errors_of(const KnownCase& known, const CaseRun& run, const CaseRun* yardstick) {
  const PerLevel<double> errors = measured(known, run, yardstick);
  WorstErrors found;
  for (std::size_t part = 0; part < run.errors.size(); ++part)
    for (std::size_t next = 0; next < run.errors[part].size(); ++next) {
      const Flag flag = run.steps.size() > static_cast<std::size_t>(known.compared[next])
                            ? run.steps[known.compared[next]].flag
                            : Flag::failed;
      if (!run.errors[part][next] || flag == Flag::other_branch) continue;
      if (!found.worst) found.worst.emplace();
      for (const Level level : all_levels) {
        // A number without a radius claims nothing, so that its error is no matter.
        if (flag == Flag::unproven && !std::isfinite(run.stated[next]->radius[level])) continue;
        const WorstError e{(*run.errors[part][next])[level], known.answers[part].floor[next][level],
                           allowed_error(known, run, errors, level, part, next)};
        WorstError& worst = (*found.worst)[level];
        if (is_worse(e, worst)) worst = e;
        if (!(e.error > e.allowed)) continue;
        const double stated = flag == Flag::unproven ? run.stated[next]->radius[level] : 0;
        const bool wrong = known.definition->bound == Bound::estimates ||
                           is_wrong(e, known.definition->scene.tolerance, stated);
        std::string& first = wrong ? found.defect : found.inexact;
        if (first.empty())
          first = formatted("%s wrong by %.1e %s, allowed %.1e", level_names[level], e.error,
                            instant_text(known, known.compared[next]).c_str(), e.allowed);
      }
    }
  return found;
}

}  // namespace desmo::extremes
