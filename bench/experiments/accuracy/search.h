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
  Problem begin;  ///< its first 101 instants, on which everything is tried
};

/// Returns the motion of a plan over a grid, and its begin, both with their references. Throws what
/// make_reference throws.
TunedMotion make_tuned_motion(const Plan& plan, const TimeGrid& grid);

/// The goal of a search: the cheapest formulation, with its settings, whose relative error is at
/// most max_error, or, where a budget is given, the most accurate within it.
struct Goal {
  Level level = Level::position;  ///< level of the error
  double max_error = 0;
  double budget = 0;  ///< s a step; 0: none
};

/// A configuration that was tried.
struct Tried {
  std::string id;
  double error;    ///< at the level of the goal; infinite when it failed
  double seconds;  ///< a step; infinite when it was not timed
  bool whole;      ///< over the whole motion, not only its begin
};

/// The result of a search.
struct Found {
  std::optional<Configuration> choice;  ///< nothing: none reaches the goal
  SolutionError error;                  ///< of the choice, over the whole motion
  double seconds = 0;                   ///< of the choice, a step, over the whole motion
  double usual_seconds = 0;             ///< of the same formulation with the paper's settings
  std::vector<Tried> tried;             ///< by time
};

/// The effort of a search: which formulations are tried, and how hard.
struct Effort {
  std::vector<const Variant*> formulations = {};  ///< none: all that the suite has
  int rounds = 9;                                 ///< samples of each time that decides
  /// Called with what is being done, for people; may be empty.
  std::function<void(const std::string&)> say = {};
};

/// An error between the instants that are compared may exceed the largest compared: a choice must
/// hold max_error over this where it is compared.
inline constexpr double safety = 2;

/// Tries formulations with their settings on the begin of a motion, and the best of them on all of
/// it. Deterministic but for the times.
Found search(const TunedMotion& motion, const Goal& goal, const Effort& effort);

}  // namespace desmo::accuracy
