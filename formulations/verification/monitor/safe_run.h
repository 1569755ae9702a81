#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "formulations/formulation.h"
#include "formulations/verification/monitor/assembly_error.h"
#include "formulations/verification/monitor/watch.h"

namespace desmo {

/// How a run ends.
enum class Outcome {
  converged,  ///< every instant as right as its tolerance asks for
  degraded,   ///< solved, but conditioning let some instants be no better than the bounds say,
              ///< relative to the scales of the motion, a singular position was passed, or an
              ///< interval that cannot be assembled
  failed,     ///< up to the instant that the summary names
};

/// An interval in which a mechanism could not be assembled, to 1e-9 s at either end.
struct Gap {
  double from, to;  ///< s
  bool ends;        ///< false: it lasts as long as the run
  Summary failure;  ///< at the first instant of the grid in it
  std::optional<AssemblyError> assembly_error;
};

/// What became of a run, and how right it is.
struct SafeSummary : Summary {
  bool refused = false;      ///< it ended at `first_degraded` or `crossing`, being strict
  double condition = 0;      ///< the largest condition number (see Assessment)
  PerLevel<double> bound{};  ///< of errors, relative to the scales of the motion
  long assessed = 0;         ///< instants
  long corrected = 0;        ///< of these
  long degraded = 0;         ///< of these
  std::optional<Degradation> first_degraded{};
  std::optional<Crossing> crossing{};             ///< the first
  std::optional<AssemblyError> assembly_error{};  ///< on failure, where no position was found
  std::vector<Gap> gaps{};                        ///< that the run went on after

  Outcome outcome() const {
    return !ok() || refused                            ? Outcome::failed
           : degraded > 0 || crossing || !gaps.empty() ? Outcome::degraded
                                                       : Outcome::converged;
  }
};

struct SafetyOptions : Watch::Options {
  bool strict = false;         ///< what is degraded has failed
  bool past_failures = false;  ///< go on after an interval that cannot be assembled
  /// Called with what is said of each instant, before the observer has it; empty: nobody listens.
  std::function<void(const Watch::Judgement&)> judged{};
};

/// Formulation::run, watched: every instant handed to the observer is as right as the summary says.
/// Ends, as a failure, at the first that cannot be assembled or is singular, the instants before it
/// handed on; or goes on where it can be assembled again from the mechanism's estimate, which
/// declares the branch. The request must ask for all coordinates: they are what is judged.
SafeSummary run_safely(Formulation& formulation, const TimeGrid& grid, const Request& request,
                       Observer& observer, const SafetyOptions& options);

/// "condition 4.1e+02, errors up to 3.2e-13, 1.1e-11 in velocity, 7.3e-11 in acceleration"
std::string describe_accuracy(double condition, const PerLevel<double>& bound, Level level);

}  // namespace desmo
