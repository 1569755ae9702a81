#pragma once

#include <optional>
#include <string>

#include "formulations/formulation.h"
#include "formulations/safety/watch.h"

namespace desmo {

/// How a run ends.
enum class Outcome {
  converged,  ///< every instant as right as its tolerance asks for
  degraded,   ///< solved, but conditioning let some instants be no better than the bounds say, or a
              ///< singular position was passed
  failed,     ///< up to the instant that the summary names
};

/// An instant that conditioning does not let be as right as its tolerance asks for.
struct Degradation {
  int index;
  double time;  ///< s
  Assessment assessment;
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
  std::optional<Crossing> crossing{};  ///< the first

  Outcome outcome() const {
    return !ok() || refused           ? Outcome::failed
           : degraded > 0 || crossing ? Outcome::degraded
                                      : Outcome::converged;
  }
};

struct SafetyOptions : Watch::Options {
  bool strict = false;  ///< what is degraded has failed
};

/// Formulation::run, watched: every instant handed to the sink is as right as the summary says.
/// Ends, as a failure, at the first that is singular, the instants before it handed on. The request
/// must ask for all coordinates: they are what is judged.
SafeSummary run_safely(Formulation& formulation, const TimeGrid& grid, const Request& request,
                       Sink& sink, const SafetyOptions& options);

/// "condition 4.1e+02, errors up to 3.2e-13, 1.1e-11 in velocity, 7.3e-11 in acceleration"
std::string describe_accuracy(double condition, const PerLevel<double>& bound, Level level);

}  // namespace desmo
