#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "formulations/base/live_row.h"
#include "formulations/formulation.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/monitor/monitored_run.h"

namespace desmo {

struct LiveOptions {
  Level level = Level::acceleration;  ///< highest level that is solved and assessed
  /// Level asked for of each coordinate (Plan::levels); empty: `level`. The memory must last until
  /// the constructor of LiveRun returns, which calls the formulation's solve_only(): that lasts.
  std::span<const Level> levels{};
  /// The velocities and accelerations that bounds are relative to, which only the caller can know
  /// in advance; empty: the largest so far, which at the beginning may be small.
  std::optional<Scales> scales{};
  /// Shorter steps that one row may take, to be solved or to be followed on its branch.
  int max_sub_steps = 64;
  bool assesses_all = false;  ///< assess every row
};

/// A fault that keeps a row from being tried.
enum class RowFault {
  none,
  wrong_size,      ///< z, ż or z̈ has not one value for each driver
  not_finite,      ///< a value or the time is not a finite number
  time_not_later,  ///< the time is that of the last good position, or before it
};

/// The outcome of one row of driver values; LiveRun itself has the coordinates that it led to.
/// outcome() says whether they may be used. It is no Summary, whose ok() tells no degraded rows.
struct [[nodiscard]] LiveSummary : BasicSummary {
  RowFault fault = RowFault::none;  ///< not none: the row was refused before anything was tried
  Assessment assessment{};          ///< of a row that was solved (MonitoredInstant)
  bool corrected = false;           ///< the values are better than the formulation's
  bool degraded = false;            ///< conditioning keeps the bounds above their limits
  std::optional<SingularityCrossing> crossing{};  ///< since the last good position
  /// First crossing since the first row or restart(): from it on every row may be on another
  /// branch.
  std::optional<SingularityCrossing> first_crossing{};
  /// Constraint that the solved position violates, since it lies on another branch; the row failed.
  int violated = no_position;

  Outcome outcome() const {
    return status != Status::solved     ? Outcome::failed
           : degraded || first_crossing ? Outcome::degraded
                                        : Outcome::converged;
  }
};

/// Returns a sentence for people, like that of a Summary; of a row that was refused, why.
std::string describe(const LiveSummary& summary, const Model& model);

/// A run whose driver values are handed in at every step, for a controller, a simulator in a loop
/// or an optimiser:
///
///   const auto formulation = make_formulation(find_variant("group_symbolic_explicit"), model);
///   LiveRun run(*formulation, {.scales = scales});
///   while (read(t, z, zd, zdd)) {
///     const LiveSummary answer = run.step({t, z, zd, zdd});
///     if (answer.outcome() != Outcome::failed) use(run.q(), run.qd(), run.qdd());
///   }
///
/// The motions of the model's drivers are not used: any will do.
/// The first row is assembled from the model's estimate. Every other row is solved from the
/// prediction or, where that fails, in sub-steps: drivers then move linearly from the last good
/// row. Every answer is monitored like those of run_monitored(). The monitor takes driver
/// values as exact. Between two rows it takes the quintic through both, or the cubic where
/// accelerations are not solved. Rows of positions alone get the rates of the way between them.
/// It follows the motion in shorter steps and assesses the row where the rates do not lead from one
/// row to the next.
///
/// Outcomes of unusual rows:
/// - NaN, infinity or a wrong size: failed, with a `fault`; nothing was tried
/// - a time that repeats or goes back: failed, with a `fault`; set_time() allows it
/// - values that jump: solved, by sub-steps; with a `crossing` where the branch was left
/// - values after a crossing: solved, and degraded, since the branch is in doubt until restart()
/// - values out of reach: failed, not_converged or singular
///
/// After a failure the values are those of the last good row, and the next row starts there. From
/// the second good row on nothing is taken from the heap, but by libraries of linear algebra.
/// explain() does, for it is not for the loop.
class LiveRun {
 public:
  /// The formulation outlives the run, which is the only one to use it. Throws
  /// std::invalid_argument where the formulation needs a motion known in advance
  /// (unsupported_live_reason), for options that are out of range, and where `levels` is not empty
  /// and has not one level for each coordinate.
  explicit LiveRun(Formulation& formulation, const LiveOptions& options = {});
  ~LiveRun();

  /// Solves and assesses one row.
  LiveSummary step(const LiveRow& given);

  /// Sets the time of the last good position [s]: the next row may have any later one.
  void set_time(double t);
  /// Forgets all rows: the next is assembled.
  void restart();

  /// Returns whether there is a good row.
  bool has_position() const { return has_position_; }
  /// The last good row: time [s] and values in coordinate order (Model::coordinates()). Those that
  /// the options leave out are unspecified.
  double time() const { return time_; }
  std::span<const double> q() const { return good_.position; }
  std::span<const double> qd() const { return good_.velocity; }
  std::span<const double> qdd() const { return good_.acceleration; }
  /// Returns the scales that bounds are relative to: those given, or the motion's so far.
  const Scales& scales() const;

  /// The obstacle to a row that could not be solved.
  struct Obstacle {
    GroupId group = no_position;   ///< group that could not be solved, if known
    int constraint = no_position;  ///< constraint most concerned, if known
    std::optional<AssemblyError> assembly_error;
  };
  /// Finds what kept the row that failed last from being solved. Allocates, and takes long.
  Obstacle explain() const;

 private:
  RowFault fault_of(const LiveRow& row) const;
  std::span<const double> rates_of(const LiveRow& row);
  bool set_drivers(const LiveRow& row);
  void assess(const LiveRow& row, LiveSummary& summary);
  void go_back();

  Formulation& formulation_;
  LiveOptions options_;  // without levels, which are in the plan of the monitors
  struct Monitors;
  std::unique_ptr<Monitors> monitors_;
  std::vector<double> unit_;            // magnitude of each driver
  PerLevel<std::vector<double>> good_;  // q, q̇ and q̈ of the last good row
  std::vector<double> tried_;           // z of the row tried last
  double time_ = 0;                     // s, of the last good row
  std::optional<SingularityCrossing> first_crossing_;
  bool has_position_ = false;
};

/// Returns why a formulation cannot be driven live, in a sentence without a full stop; empty when
/// it can.
std::string unsupported_live_reason(const Formulation& formulation);

}  // namespace desmo
