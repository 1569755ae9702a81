#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "cases/mechanism/motion.h"
#include "cases/mechanism/scene.h"
#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/assessment/assessment.h"

namespace desmo {

class PivotReuse;  // algebra/linear_solver.h, which is not installed

/// Signal that makes the accuracy monitor assess an instant, or check of the assessment.
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

  double tolerance = default_tolerance;  ///< of Settings; run_monitored() takes the formulation's
  std::span<const Level> levels{};       ///< to which each coordinate is solved (Plan::levels)
  std::span<const Level> asked{};        ///< to which it is judged; empty: as far as solved
  int every = usual_interval;            ///< longest interval between assessments, in instants
  bool reuses_pivots = false;            ///< Part::reuses_pivots: rates may be spoilt
  /// Parts whose shrunk pivots show when they do; empty: not known, residuals of rates tell.
  std::vector<const PivotReuse*> parts{};
  unsigned without = 0;            ///< Monitor bits left out, for tests of what each finds
  std::optional<Scales> scales{};  ///< to which bounds are relative; empty: the motion's
  int max_steps = 4096;            ///< shorter steps in which a doubtful step is gone again
  int max_degradations = 1000000;  ///< degraded instants reconsidered when scales grow
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
  /// No angle is half a turn from where the instant before leads it: see BranchMonitor.
  bool angles_follow = false;
  std::optional<SingularityCrossing> crossing{};
  Assessment assessment{};  ///< assessed, or an expectation with margin (Expectation)
};

/// Monitors the accuracy of a motion's instants at little cost. It assesses (Assessor) the first
/// instant, and others when the clock has come round. It also does so when a signal has grown by a
/// factor of four since the last assessment. A smaller growth suffices where correcting would pay
/// (Expectation). The signals:
///
///   sensitivity  the largest rate of a group's unknowns over that of the drivers; it grows as the
///                condition number does, unless the motion happens not to show it
///                (ConditionMonitor)
///   residual     ‖Φ‖, to which the error of position is proportional; where pivots are reused,
///                the residuals of Φ̇ and Φ̈ as well (BackwardError)
///
/// If an expected bound exceeds the limits of *degraded*, the monitor assesses the instant.
/// Interpolated instants are checked by the residuals of Φ, Φ̇ and Φ̈, too. One that exceeds the
/// limits, or to which the instant before it does not lead, is refused
/// (MonitoredInstant::too_coarse).
///
/// The monitor corrects an instant with factors at its own position, and assesses it again, when
/// its bounds are too large. The limits are 10, 10² and 10³ times the tolerance in position,
/// velocity and acceleration, and at least ten times what conditioning allows (accuracy_limit()).
/// An instant that is still above 100, 100² and 100³ times the tolerance is *degraded*. The
/// instants after it are assessed until one is not.
class AccuracyMonitor {
 public:
  /// Prepares for a motion; its grid yields the drivers' rates in advance. The model must outlive
  /// the monitor.
  AccuracyMonitor(const Model& model, const TimeGrid& grid, const AccuracyMonitorOptions& options);
  ~AccuracyMonitor();

  /// Examines the next instant; instants come in order of time. Allocates only in KLU and for
  /// degraded instants.
  MonitoredInstant examine(const Instant& instant);

  /// Returns what singular instant lies between two regular ones near it, interpolated and
  /// degraded, if the motion is smooth there (Continuity::pass). The instant is the one examined
  /// last.
  std::optional<MonitoredInstant> pass(const Instant& singular);
  /// Solves an instant that could not be solved otherwise, in short steps from the one before it.
  std::optional<MonitoredInstant> solve(const Instant& instant);
  /// Solves the instant examined last again, from the one before it: it is on another branch.
  std::optional<MonitoredInstant> solve_again(const Instant& instant);
  /// Returns positions from which the motion goes on, and their time [s]: of the last instant, or
  /// beyond the singular position that it lies in. Empty: there was none.
  struct Start {
    std::span<const double> q;
    double time;
  };
  Start last() const;
  /// Assesses the instants before one that turned out worse than it was expected to be, the latest
  /// first, until one is as stated. Those that are not raise the bounds.
  void look_back(const Instant& like);

  /// Tells that the next instant does not follow the last one; the monitor will assess it.
  void resume();

  /// Doubts the step to the next instant: the monitor goes it again and assesses its end.
  void doubt_next();
  /// Counts time from an origin that is `by` [s] earlier.
  void shift_time(double by);

  /// Return the numbers of instants assessed and corrected.
  long assessed() const;
  long corrected() const;
  /// Returns the largest condition number of all instants; between assessments it is expected.
  double condition() const;
  /// Returns the largest bounds so far, relative to the scales of the motion so far.
  const PerLevel<double>& bound() const;
  /// Return the number of degraded instants, relative to the motion so far, and the first of them.
  /// Instants at rest, early in a motion, may stop counting when rates have grown.
  long degraded() const;
  std::optional<Degradation> first_degraded() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace desmo
