#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "cases/mechanism/motion.h"
#include "formulations/base/observer.h"
#include "formulations/base/part.h"
#include "formulations/model/model.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/monitor/assessment.h"

namespace desmo {

/// A signal that makes the accuracy monitor assess an instant, or a check of the assessment.
enum class Monitor : unsigned {
  sensitivity = 1,   ///< rates of unknowns over those of the drivers
  residual = 2,      ///< ‖Φ‖ at which positions were accepted
  clock = 4,         ///< the number of instants since the last assessment
  bounds = 8,        ///< tells degraded and singular instants from others
  orientation = 16,  ///< signs of the determinants of irreducible blocks
  continuity = 32    ///< whether rates lead from each instant to the next (Continuity)
};

struct MonitorName {
  Monitor monitor;
  std::string_view name;
};
inline constexpr std::array monitor_names{
    MonitorName{Monitor::sensitivity, "sensitivity"},
    MonitorName{Monitor::residual, "residual"},
    MonitorName{Monitor::clock, "clock"},
    MonitorName{Monitor::bounds, "bounds"},
    MonitorName{Monitor::orientation, "orientation"},
    MonitorName{Monitor::continuity, "continuity"},
};

/// Settings of an accuracy monitor.
struct AccuracyMonitorOptions {
  static constexpr int usual_interval = 2000;

  double tolerance = default_tolerance;  ///< to which positions are solved
  std::span<const Level> levels{};       ///< to which each coordinate is solved (Plan::levels)
  int every = usual_interval;            ///< instants from one assessment to the next, at most
  bool reuses_pivots = false;            ///< rates may come from pivots of another position
  unsigned without = 0;                  ///< Monitor bits left out, for tests of what each finds
  std::optional<Scales> scales{};        ///< to which bounds are relative; empty: the motion's
  int max_steps = 4096;                  ///< shorter steps in which a doubtful step is gone again
  int max_degradations = 10000;          ///< degraded instants reconsidered when scales grow
};

/// An instant with what the accuracy monitor says of it.
struct MonitoredInstant {
  Instant instant;           ///< possibly corrected; valid until the next instant
  bool degraded = false;     ///< conditioning lets it be no better than its bounds
  bool solved_anew = false;  ///< it was interpolated, and that was not good enough
  std::optional<SingularityCrossing> crossing{};
  Assessment assessment{};  ///< of this instant; an expectation where it was not assessed
};

/// Monitors the accuracy of a motion's instants at little cost. It assesses an instant (Assessor)
/// when the instant is the first, when the clock has come round, and when a signal has moved by a
/// factor of four since the last assessment, or by less where correcting would pay (Expectation):
///
///   sensitivity  the largest rate of an unknown of a group over that of the drivers; it grows as
///                the condition number does, unless the motion happens not to show it
///                (ConditionMonitor)
///   residual     ‖Φ‖, to which the error of position is proportional; where pivots are reused,
///                the residuals of Φ̇ and Φ̈ as well (BackwardError)
///
/// Interpolated instants are assessed by the residuals of Φ, Φ̇ and Φ̈. An interpolated instant that
/// exceeds the limits of *degraded* is solved from the instant before it. The monitor never states
/// more than these limits of an instant that it has not assessed: it assesses it instead.
///
/// The monitor corrects an instant with factors of its own position, and assesses it again, when
/// its bounds exceed 10, 10² and 10³ times the tolerance in position, velocity and acceleration and
/// ten times what conditioning allows (accuracy_limit). An instant that is still above 100, 100²
/// and 100³ times the tolerance is *degraded*; the instants after it are assessed until one is not.
class AccuracyMonitor {
 public:
  /// Prepares for a motion; its grid tells how fast the drivers will be. The model must outlive the
  /// monitor.
  AccuracyMonitor(const Model& model, const TimeGrid& grid, const AccuracyMonitorOptions& options);
  ~AccuracyMonitor();

  /// Examines the next instant; instants come in order of time. Takes nothing from the heap but by
  /// KLU and for degraded instants.
  MonitoredInstant examine(const Instant& instant);

  /// Says that the next instant does not follow the last one; the monitor will assess it.
  void resume();

  /// Doubts the step to the next instant: the monitor goes it again and assesses its end.
  void doubt_next();
  /// Counts time from an origin that is `by` [s] earlier.
  void shift_time(double by);

  /// Return the numbers of instants assessed and corrected.
  long assessed() const;
  long corrected() const;
  /// Returns the largest condition number of all instants, between assessments by their signals.
  double condition() const;
  /// Returns the largest bounds so far, relative to the scales of the motion so far.
  const PerLevel<double>& bound() const;
  /// Return the number of instants that are degraded relative to the motion so far, and the first
  /// of them. Rates at rest, early in a motion, may have been rounding compared with later ones.
  long degraded() const;
  std::optional<Degradation> first_degraded() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace desmo
