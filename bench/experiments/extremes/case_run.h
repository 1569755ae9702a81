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
  converged,       ///< numbers at all instants, none flagged
  degraded,        ///< numbers at all instants, some flagged: not proven, or on a doubtful branch
  failed,          ///< no numbers at one instant at least
  refused,         ///< the case was rejected before anything was solved
  not_applicable,  ///< not tried: the formulation does not offer it, or would take too long
};

/// The run of a case in one formulation.
struct CaseRun {
  enum class Flag {
    none,
    unproven,      ///< numbers with a flag: not proven, or contradicting equations
    other_branch,  ///< numbers with a flag: at or after a singular position, or on another branch
    failed,        ///< no numbers
  };
  struct Step {
    Flag flag = Flag::none;
    double iterations = 0;  ///< Newton iterations, the mean over all moving unknowns
  };
  /// Statements of the proof about an instant.
  struct Stated {
    double condition;
    /// Largest radius of all coordinates, divided by Answers::scales of the first answers; in
    /// `max`, and where there are no answers, by the scales of the run. Infinite: a coordinate has
    /// no proof.
    PerLevel<double> radius;
  };

  /// Returns the outcome by the worst of the steps' flags; `unsolved` where that is set.
  CaseOutcome outcome() const;

  std::optional<CaseOutcome> unsolved;  ///< refused or not_applicable; nothing: it was tried
  std::string message;                  ///< first failure or flag, or why it was not tried
  std::vector<Step> steps;              ///< one for each instant, or start, tried from the first on
  /// Errors for each of the case's answers, at each instant compared; nothing where there are no
  /// numbers or nothing is known.
  std::vector<std::vector<std::optional<PerLevel<double>>>> errors;
  std::vector<std::optional<Stated>> stated;  ///< one for each compared instant, if it was solved
  Stated max{};               ///< condition: largest of all instants; radius: of the proven ones
  std::vector<Gap> gaps;      ///< gaps of the runs, the last of which may reach to the end
  GroupId failed_group = -1;  ///< group that failed first; -1: none, or not known
  /// Bytes by which the heap grew from the first solved instant (or start) after the 1000th to the
  /// last one; 0 where the last is not solved.
  std::int64_t heap_growth = 0;
};

/// Solves the case as `desmo solve` does (run_checked): to the first failure or, if
/// ExtremeCase::past_failures, to the end; with ExtremeCase::starts, its first instant from each
/// start.
CaseRun run_case(const KnownCase& known, const Configuration& configuration);

}  // namespace desmo::extremes
