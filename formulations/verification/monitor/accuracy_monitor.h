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
#include "formulations/verification/monitor/monitored_run.h"

namespace desmo {

class Part;  // base/part.h

/// A monitor or a rule of a monitored run, which tests leave out to see what it alone finds.
enum class Monitor : unsigned {
  // Signals that make the accuracy monitor assess an instant, and checks of the assessment.
  sensitivity = 1 << 0,  ///< rates of unknowns over those of the drivers
  condition = 1 << 1,    ///< growth of the condition number that rates do not show
  residual = 1 << 2,     ///< ‖Φ‖ at which positions were accepted
  bounds = 1 << 3,       ///< tells degraded and singular instants from others
  orientation = 1 << 4,  ///< signs of the determinants of irreducible blocks
  continuity = 1 << 5,   ///< whether rates lead from each instant to the next (Continuity)
  turns = 1 << 6,        ///< drivers that turn back within a step (DriverTurns)
  branch = 1 << 7,       ///< conditions beyond the equations that were solved (BranchMonitor)
  // Reactions to what is found.
  correction = 1 << 8,     ///< Newton's method makes one more correction (OneMoreCorrection)
  repair = 1 << 9,         ///< instants are corrected, doubtful steps retried in shorter ones
  measurement = 1 << 10,   ///< the error is measured where a bound would flag it (MeasuredError)
  pivots = 1 << 11,        ///< reused pivots that have shrunk: residuals of rates
  rows = 1 << 12,          ///< interpolated instants are judged
  passage = 1 << 13,       ///< singular positions at which the motion is smooth are passed
  continuation = 1 << 14,  ///< a start on another branch is reached from the nominal position
  redundancy = 1 << 15,    ///< others of a group's equations are chosen where those kept are poor
  // Measures by which all of it is judged.
  scales = 1 << 16,   ///< errors are relative to the whole motion, not to each instant
  lengths = 1 << 17,  ///< each block is judged by itself, in its own lengths (Norm)
  cause = 1 << 18,    ///< what limits an instant is found; else a singular position is blamed
};

struct MonitorName {
  Monitor monitor;
  std::string_view name;
};
inline constexpr std::array monitor_names{
    MonitorName{Monitor::sensitivity, "sensitivity"},
    MonitorName{Monitor::condition, "condition"},
    MonitorName{Monitor::residual, "residual"},
    MonitorName{Monitor::bounds, "bounds"},
    MonitorName{Monitor::orientation, "orientation"},
    MonitorName{Monitor::continuity, "continuity"},
    MonitorName{Monitor::turns, "turns"},
    MonitorName{Monitor::branch, "branch"},
    MonitorName{Monitor::correction, "correction"},
    MonitorName{Monitor::repair, "repair"},
    MonitorName{Monitor::measurement, "measurement"},
    MonitorName{Monitor::pivots, "pivots"},
    MonitorName{Monitor::rows, "rows"},
    MonitorName{Monitor::passage, "passage"},
    MonitorName{Monitor::continuation, "continuation"},
    MonitorName{Monitor::redundancy, "redundancy"},
    MonitorName{Monitor::scales, "scales"},
    MonitorName{Monitor::lengths, "lengths"},
    MonitorName{Monitor::cause, "cause"},
};

/// Runs like run_monitored(), without some monitors and rules. without: their bits.
MonitoredSummary run_monitored_without(unsigned without, Formulation& formulation,
                                       const TimeGrid& grid, const Request& request,
                                       Observer& observer, const MonitoredRunOptions& options);

/// Settings of an accuracy monitor.
struct AccuracyMonitorOptions {
  double tolerance = default_tolerance;  ///< of Settings; run_monitored() takes the formulation's
  std::span<const Level> levels{};       ///< to which each coordinate is solved (Plan::levels)
  std::span<const Level> asked{};        ///< to which it is judged; empty: as far as solved
  bool assesses_all = false;             ///< assess every instant
  bool reuses_pivots = false;            ///< Pivots::may_spoil_rates of any part
  /// Parts whose shrunk pivots show when they do; empty: not known, residuals of rates tell.
  std::vector<const Part*> parts{};
  unsigned without = 0;            ///< Monitor bits left out
  std::optional<Scales> scales{};  ///< to which bounds are relative; empty: the motion's
  int max_steps = 4096;            ///< shorter steps in which a doubtful step is retried
  int max_degradations = 1000000;  ///< degraded instants reconsidered when scales grow
  /// Follow a crossing closely, and choose other equations, for which memory is taken.
  bool may_allocate = true;
};

/// Monitors the accuracy of a motion's instants at little cost. It assesses (Assessor) the first
/// instant, and others when a signal has grown by a factor of four since the last assessment. A
/// smaller growth suffices where correcting would pay (Expectation). The signals:
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
  /// Positions from which the motion goes on, and their time.
  struct Start {
    std::span<const double> q;  // empty: there was no instant
    double time;                // s
  };
  /// Returns where the motion goes on: at the last instant, or beyond the singular position that
  /// it lies in.
  Start last() const;

  /// Tells that the instant examined last is not delivered, so that it does not count.
  void withdraw(const Instant& instant);
  /// Tells that the next instant does not follow the last one; the monitor will assess it.
  void resume();

  /// Lets the motion rest at the last instant: its rates become 0.
  void rest();
  /// Doubts the step to the next instant: the monitor goes it again and assesses its end.
  void doubt_next();
  /// Counts time from an origin that is `by` [s] earlier.
  void shift_time(double by);

  /// Return the numbers of instants assessed and corrected.
  long assessed() const;
  long corrected() const;
  /// Returns the largest condition number of all instants; between assessments it is expected.
  double condition() const;
  /// Return the largest bounds so far, and the scales of the motion so far that they are relative
  /// to.
  const PerLevel<double>& bound() const;
  const Scales& scales() const;
  /// Return the number of degraded instants, relative to the motion so far, and the first of them.
  /// Instants at rest, early in a motion, may stop counting when rates have grown.
  long degraded() const;
  std::optional<Degradation> first_degraded() const;

 private:
  struct State;
  bool examine_with_others(MonitoredInstant& j, const Instant& instant);

  std::unique_ptr<State> state_;
};

}  // namespace desmo
