#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/accuracy/trial.h"

namespace desmo::accuracy {

/// A motion for which settings are chosen.
struct TunedMotion {
  Problem whole;
  Problem beginning;  ///< its first 101 instants, or all if fewer, on which everything is tried
};

/// Returns the motion of a plan over a grid, and its beginning, both with their references. Throws
/// what make_reference throws.
TunedMotion make_tuned_motion(const Plan& plan, const TimeGrid& grid);

/// The goal of a search. Without a budget it is the cheapest formulation, with its settings, whose
/// relative error is at most max_error (see error_margin). With one it is the most accurate within
/// the budget.
struct Goal {
  Level level = Level::position;  ///< level of the error
  double max_error = 0;           ///< largest relative error (SolutionError); unused with a budget
  double budget = 0;              ///< largest time of a step [s] (≤); 0: no budget
};

/// A configuration that was tried.
struct TriedConfiguration {
  std::string id;
  double error;    ///< largest relative error at the goal's level; infinite when it failed
  double seconds;  ///< least time of a step [s]; infinite when it was not timed
  bool whole;      ///< it was tried on the whole motion, not only on its beginning
};

/// The result of a search.
struct SearchResult {
  std::optional<Configuration> choice;  ///< nothing: none reaches the goal
  SolutionError error;                  ///< errors of the choice over the whole motion
  double seconds = 0;                   ///< time of a step of the choice, on the whole motion [s]
  double usual_seconds = 0;             ///< the same with the paper's settings [s]
  /// Trials of the full settings grids on the beginning, and of the last candidates on the whole
  /// motion, in ascending order of `seconds`.
  std::vector<TriedConfiguration> tried;
};

/// The effort of a search: which formulations are tried, and how hard.
struct SearchOptions {
  /// Formulations to try; none: all that the suite has, dense global ones for small models only.
  std::vector<const Variant*> formulations = {};
  int rounds = 9;  ///< number of samples of each time that decides
  /// Function that is told what is being done, for people; may be empty.
  std::function<void(const std::string&)> say = {};
};

/// Factor by which an error between compared instants may exceed the largest one compared. At
/// compared instants a choice must have an error of at most max_error / error_margin.
inline constexpr double error_margin = 2;

/// Tries formulations with their settings on the beginning of a motion, and the best of them on all
/// of it. The result depends on times that are measured, and on nothing else that may vary.
SearchResult search(const TunedMotion& motion, const Goal& goal, const SearchOptions& options);

}  // namespace desmo::accuracy
