#pragma once

#include <string>
#include <vector>

#include "bench/stability/problem.h"
#include "formulations/id.h"

namespace desmo::extreme {

/// What became of a case in one formulation.
struct Attempt {
  enum class Ending {
    tried,           ///< see steps
    refused,         ///< before anything was solved
    not_applicable,  ///< the formulation cannot do it
  };
  struct Step {
    bool flagged;  ///< no numbers, and it said so
    int iterations;
  };

  Ending ending = Ending::tried;
  std::string message;      ///< of the first flag, or why not
  std::vector<Step> steps;  ///< of the instants, or starts, tried: from the first on
  /// Of each of the problem's answers, of each instant compared; nothing where it has no numbers or
  /// nothing is known.
  std::vector<std::vector<std::optional<PerLevel<double>>>> errors;
  GroupId failed_group = -1;  ///< of the first flag
};

/// Solves the problem, step by step, to the first flag or, where the case says so, past it; or from
/// every start.
Attempt attempt(const Problem& problem, const Configuration& configuration);

}  // namespace desmo::extreme
