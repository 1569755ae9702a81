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
  Problem beginning;  ///< its first 101 instants, on which everything is tried
};

/// Returns the motion of a plan over a grid, and its beginning, both with their references. Throws
/// what make_reference throws.
TunedMotion make_tuned_motion(const Plan& plan, const TimeGrid& grid);

/// The goal of a search: the cheapest formulation, with its settings, whose relative error is at
/// most max_error, or, where a budget is given, the most accurate within it.
struct Goal {
  Level level = Level::position;  ///< level of the error
  double max_error = 0;
  double budget = 0;  ///< s a step; 0: none
};

/// A configuration that was tried.
struct TriedConfiguration {
  std::string id;
  double error;    ///< at the level of the goal; infinite when it failed
  double seconds;  ///< a step; infinite when it was not timed
  bool whole;      ///< over the whole motion, not only its beginning
};

/// The result of a search.
struct SearchResult {
  std::optional<Configuration> choice;    ///< nothing: none reaches the goal
  SolutionError error;                    ///< of the choice, over the whole motion
  double seconds = 0;                     ///< of the choice, a step, over the whole motion
  double usual_seconds = 0;               ///< of the same formulation with the paper's settings
  std::vector<TriedConfiguration> tried;  ///< by time
};

/// The effort of a search: which formulations are tried, and how hard.
struct SearchOptions {
  std::vector<const Variant*> formulations = {};  ///< none: all that the suite has
  int rounds = 9;                                 ///< samples of each time that decides
  /// Function that is told what is being done, for people; may be empty.
  std::function<void(const std::string&)> say = {};
};

/// Factor by which the error between compared instants may exceed the largest one compared: there a
/// choice must hold max_error over this.
inline constexpr double error_margin = 2;

/// Tries formulations with their settings on the beginning of a motion, and the best of them on all
/// of it. Deterministic but for the times.
SearchResult search(const TunedMotion& motion, const Goal& goal, const SearchOptions& options);

}  // namespace desmo::accuracy
