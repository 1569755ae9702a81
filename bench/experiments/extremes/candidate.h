#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/experiments/extremes/problem.h"
#include "formulations/id.h"
#include "formulations/verification/monitor/safe_run.h"

namespace desmo::extremes {

/// What became of a case in one formulation.
struct Attempt {
  enum class Ending {
    tried,           ///< see steps
    refused,         ///< before anything was solved
    not_applicable,  ///< the formulation cannot do it
  };
  enum class Flag {
    none,
    degraded,  ///< numbers, said to be no better than their bounds
    doubtful,  ///< numbers, said to be behind a singular position or on another branch
    failed,    ///< no numbers
  };
  struct Step {
    Flag flag = Flag::none;
    double iterations = 0;  ///< of Newton's method, the mean over all unknowns
  };
  /// What was said of an instant.
  struct Stated {
    double condition;
    PerLevel<double> bound;
  };

  Ending ending = Ending::tried;
  std::string message;      ///< of the first flag, or why not
  std::vector<Step> steps;  ///< of the instants, or starts, tried: from the first on
  long iterations = 0;
  /// Of each of the problem's answers, of each instant compared; nothing where it has no numbers or
  /// nothing is known.
  std::vector<std::vector<std::optional<PerLevel<double>>>> errors;
  std::vector<std::optional<Stated>> stated;  ///< of each instant compared
  Stated most{};                              ///< that was said of all instants together
  std::vector<Gap> gaps;                      ///< that it went on after
  GroupId failed_group = -1;                  ///< of the first flag
  long refactorisations = 0;                  ///< of pivots kept that had gone bad
  /// Bytes by which the heap has grown from the first that is solved after 1000 instants, or
  /// starts, to the last; 0 where the last is not solved.
  std::int64_t heap_growth = 0;
};

/// Solves the problem as `desmo solve` does (run_safely), to the first failure or, where the case
/// says so, past it; or from every start. without: monitors left out.
Attempt attempt(const Problem& problem, const Configuration& configuration, unsigned without = 0);

}  // namespace desmo::extremes
