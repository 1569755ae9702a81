#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "formulations/formulation.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/assessment/assembly_error.h"
#include "formulations/verification/assessment/assessment.h"

namespace desmo {

/// Outcome of a monitored run.
enum class Outcome {
  converged,  ///< bounds of position, velocity and acceleration are within 100, 100² and 100³
              ///< times the tolerance
  degraded,   ///< solved, but conditioning keeps some instants from meeting their limits, or a
              ///< singular position or a gap was passed
  failed,     ///< solved only before the instant that the summary names
};

/// Interval in which a mechanism could not be assembled. Its ends are accurate to 1e-9 s or, where
/// that is more, to what rounding of time and of the drivers leaves.
struct Gap {
  double from, to;  ///< [s]
  bool ends;        ///< false: the interval lasts until the end of the run
  Summary failure;  ///< failure at the interval's first grid instant
  std::optional<AssemblyError> assembly_error;
};

/// Outcome of a monitored run and accuracy of its instants. outcome() says whether its answers may
/// be used. It is no Summary, whose ok() tells neither degraded instants nor another branch.
struct [[nodiscard]] MonitoredSummary : BasicSummary {
  bool refused = false;  ///< a strict run ended at `first_degraded` or `crossing`
  /// Constraint that the last instant violates, since it lies on another branch. One of its
  /// equations was left out as dependent, or its angle turned by half a turn. The instant was not
  /// delivered.
  int violated = no_position;
  /// Cause of a failure as singular or on another branch, where rounding is to blame.
  std::optional<Limit> limit{};
  double condition = 0;      ///< largest condition number (see Assessment)
  PerLevel<double> bound{};  ///< error bounds, relative to `scales`
  Scales scales{};           ///< scales of the motion
  long assessed = 0;         ///< instants assessed
  long corrected = 0;        ///< instants corrected
  long degraded = 0;         ///< instants degraded
  int shortest_stride = 0;   ///< to which a stride was halved; 0: it was not
  std::optional<Degradation> first_degraded{};
  std::optional<SingularityCrossing> crossing{};  ///< first crossing
  std::optional<AssemblyError> assembly_error{};  ///< on failure, where no position was found
  std::vector<Gap> gaps{};                        ///< gaps after which the run went on

  Outcome outcome() const {
    return status != Status::solved || refused || violated >= 0 ? Outcome::failed
           : degraded > 0 || crossing || !gaps.empty()          ? Outcome::degraded
                                                                : Outcome::converged;
  }
};

/// An instant and its accuracy.
struct MonitoredInstant {
  Instant instant;        ///< corrected where that helped; valid until the next instant
  bool degraded = false;  ///< conditioning keeps it from meeting the limits
  /// It jumped to another branch, or lies in a singular position, and was then solved from the
  /// instant before it.
  bool solved_anew = false;
  /// It was interpolated, and is not as accurate as solved instants are to be. It counts nowhere:
  /// the caller solves it, or hands in one of a shorter stride.
  bool too_coarse = false;
  /// No angle is half a turn from where the rates of the instant before lead it.
  bool angles_follow = false;
  std::optional<SingularityCrossing> crossing{};
  /// Between two assessments it is predicted, with a margin, from the last one, the residual and
  /// the growth of the condition number.
  Assessment assessment{};
};

/// Settings of a monitored run. The tolerance is Formulation::tolerance().
struct MonitoredRunOptions {
  /// Level asked for of each coordinate (Plan::levels); empty: that of the request. Where it asks
  /// for positions alone, the formulation's solve_only() is called, which lasts. The memory must
  /// last until run_monitored() returns.
  std::span<const Level> levels{};
  bool strict = false;         ///< assess every instant; fail at a degraded one or a crossing
  bool past_failures = false;  ///< continue after an interval that cannot be assembled
  bool assesses_all = false;   ///< assess every instant
  /// Callback that receives each instant before the observer does; empty: none. It must not throw:
  /// it is called through Observer::observe(), where an exception ends the program.
  std::function<void(const MonitoredInstant&)> monitored{};
  /// Callback that returns what the observer receives in an instant's place, valid until the next
  /// one; empty: the instant itself. The run goes on from the instant. It must not throw, either.
  std::function<Instant(const Instant&)> refined{};
};

/// Runs a motion like Formulation::run() and monitors it: every instant that the observer receives
/// is as accurate as the summary states. The run ends, as a failure, at the first instant that
/// cannot be assembled, is singular or lies on another branch. All instants before it were
/// delivered. With `past_failures` it continues at the next instant that can be assembled from the
/// model's initial estimate, which declares the branch. Throws std::invalid_argument for a request
/// that names coordinates: the monitors need all. Throws it, too, where `levels` is not empty and
/// has not one level for each coordinate.
///
///   const auto formulation = make_formulation(find_variant("block_symbolic_inlined"), model);
///   const MonitoredSummary s = run_monitored(*formulation, grid, {Level::acceleration}, observer);
///   if (s.outcome() != Outcome::converged) std::cerr << describe(s, model);
MonitoredSummary run_monitored(Formulation& formulation, const TimeGrid& grid,
                               const Request& request, Observer& observer,
                               const MonitoredRunOptions& options = {});

/// Returns the outcome in a line: what failed when and where, and what was flagged before; or what
/// was flagged first, and the accuracy of the instants. model: the formulation's.
std::string describe(const MonitoredSummary& summary, const Model& model);

/// Returns the accuracy in words, up to a level: "condition 4.1e+02, errors up to 3.2e-13, 1.1e-11
/// in velocity, 7.3e-11 in acceleration".
std::string describe_accuracy(double condition, const PerLevel<double>& bound, Level level);

/// Returns the scales in words, up to a level: "relative to 0.2 m or 1 rad, 1.3 m/s or 6.3 rad/s, 8
/// m/s^2 or 39 rad/s^2".
std::string describe_scales(const Scales& scales, Level level, const Model& model);

}  // namespace desmo
