#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "formulations/formulation.h"
#include "formulations/verification/monitor/accuracy_monitor.h"
#include "formulations/verification/monitor/assembly_error.h"

namespace desmo {

/// How a monitored run ends.
enum class Outcome {
  converged,  ///< every instant is as right as its tolerance asks for
  degraded,   ///< solved, but some instants are no better than the bounds say, since conditioning
              ///< allows no more, or a singular position or a gap was passed
  failed,     ///< solved only before the instant that the summary names
};

/// An interval in which a mechanism could not be assembled, to 1e-9 s at either end.
struct Gap {
  double from, to;  ///< [s]
  bool ends;        ///< false: it lasts as long as the run
  Summary failure;  ///< at the first instant of the grid in it
  std::optional<AssemblyError> assembly_error;
};

/// The outcome of a monitored run and the accuracy of its instants.
struct MonitoredSummary : Summary {
  bool refused = false;      ///< a strict run ended at `first_degraded` or `crossing`
  int violated = -1;         ///< the constraint that the last instant satisfies only on another
                             ///< branch (BranchMonitor); that instant was not handed on
  double condition = 0;      ///< the largest condition number (see Assessment)
  PerLevel<double> bound{};  ///< of errors, relative to the scales of the motion
  long assessed = 0;         ///< instants
  long corrected = 0;        ///< instants
  long degraded = 0;         ///< instants
  std::optional<Degradation> first_degraded{};
  std::optional<SingularityCrossing> crossing{};  ///< the first
  std::optional<AssemblyError> assembly_error{};  ///< on failure, where no position was found
  std::vector<Gap> gaps{};                        ///< those after which the run went on

  Outcome outcome() const {
    return !ok() || refused || violated >= 0           ? Outcome::failed
           : degraded > 0 || crossing || !gaps.empty() ? Outcome::degraded
                                                       : Outcome::converged;
  }
};

/// Settings of a monitored run.
struct MonitoredRunOptions : AccuracyMonitorOptions {
  bool strict = false;         ///< assess every instant; an instant that is degraded has failed
  bool past_failures = false;  ///< go on after an interval that cannot be assembled
  /// Called with each instant before the observer has it; empty: nobody listens.
  std::function<void(const MonitoredInstant&)> monitored{};
};

/// Runs through a motion as Formulation::run() does, and monitors it: every instant that the
/// observer receives is as right as the summary says. The run ends, as a failure, at the first
/// instant that cannot be assembled, is singular or lies on another branch; all instants before it
/// were handed on. With `past_failures` it goes on where the mechanism can be assembled again from
/// the model's estimate, which declares the branch. The request must ask for all coordinates, since
/// the monitor needs them.
///
///   const auto formulation = make_formulation(find_variant("block_symbolic_inlined"), model);
///   const MonitoredSummary s = run_monitored(*formulation, grid, {Level::acceleration}, observer);
///   if (s.outcome() != Outcome::converged) std::cerr << describe(s, model);
MonitoredSummary run_monitored(Formulation& formulation, const TimeGrid& grid,
                               const Request& request, Observer& observer,
                               const MonitoredRunOptions& options = {});

/// Returns "condition 4.1e+02, errors up to 3.2e-13, 1.1e-11 in velocity, 7.3e-11 in acceleration"
std::string describe_accuracy(double condition, const PerLevel<double>& bound, Level level);

}  // namespace desmo
