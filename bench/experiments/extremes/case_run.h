#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/extremes/known_case.h"
#include "formulations/id.h"
#include "formulations/verification/run/checked_run.h"

namespace desmo::extremes {

enum class CaseOutcome {
  converged,       ///< numbers everywhere, without a flag
  degraded,        ///< with one: not proven, or in doubt
  failed,          ///< no numbers at one instant at least
  refused,         ///< before anything was solved
  not_applicable,  ///< not tried: the formulation cannot do it
};

/// The run of a case in one formulation.
struct CaseRun {
  enum class Flag {
    none,
    unproven,      ///< numbers, said to be not proven, or to contradict equations
    other_branch,  ///< numbers, said to be after a singular position or on another branch
    failed,        ///< no numbers
  };
  struct Step {
    Flag flag = Flag::none;
    double iterations = 0;  ///< of Newton's method, the mean over all unknowns
  };
  /// Statements of the proof about an instant.
  struct Stated {
    double condition;
    PerLevel<double> radius;  ///< over the scales that errors are taken over
  };

  /// Returns the worst of the flags, or why there are none.
  CaseOutcome outcome() const;

  std::optional<CaseOutcome> unsolved;  ///< refused, not_applicable; nothing: see steps
  std::string message;                  ///< of the first flag, or why not
  std::vector<Step> steps;              ///< of the instants, or starts, tried: from the first on
  /// Errors for each of the case's answers, at each instant compared; nothing where there are no
  /// numbers or nothing is known.
  std::vector<std::vector<std::optional<PerLevel<double>>>> errors;
  std::vector<std::optional<Stated>> stated;  ///< by instant compared
  Stated max{};                               ///< over all instants
  std::vector<Gap> gaps;                      ///< gaps after which the run went on
  GroupId failed_group = -1;                  ///< of the first flag
  /// Bytes by which the heap grew from the first solved instant (or start) after the 1000th to the
  /// last one; 0 where the last is not solved.
  std::int64_t heap_growth = 0;
};

/// Solves the case as `desmo solve` does (run_checked), to the first failure or, where the case
/// says so, past it; or from every start.
CaseRun run_case(const KnownCase& known, const Configuration& configuration);

}  // namespace desmo::extremes
