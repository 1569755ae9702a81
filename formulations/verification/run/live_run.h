#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "formulations/base/live_row.h"
#include "formulations/formulation.h"
#include "formulations/model/scales.h"
#include "formulations/verification/branch/followed_step.h"
#include "formulations/verification/run/check_options.h"
#include "formulations/verification/run/checked_run.h"

namespace desmo {

struct RefinedInstant;

/// Options of a live run, which hold for all its rows.
struct LiveOptions {
  Level level = Level::acceleration;  ///< highest level that is solved and proven
  /// Level requested of each coordinate (Plan::levels); empty: `level`. The constructor of LiveRun
  /// hands it to the formulation (solve_only()), which keeps to it. The memory must last until the
  /// constructor returns.
  std::span<const Level> levels{};
  /// Scales that radii are divided by, which only the caller can know in advance. Empty: the
  /// largest velocities and accelerations so far, which at the beginning may be small.
  std::optional<Scales> scales{};
  /// Maximum number of sub-steps in which a row is solved. Its proof may take max_sub_steps + 1
  /// tests (FollowedStep::tests).
  int max_sub_steps = 64;
  CheckMode check = CheckMode::proof;  ///< none or proof
};

/// A fault that keeps a row from being tried.
enum class RowFault {
  none,
  wrong_size,      ///< z, ż or z̈ has not one value for each driver
  not_finite,      ///< a value or the time is not a finite number
  time_not_later,  ///< the time is that of the last good position, or before it
};

/// Summary of one row of driver values. LiveRun has the coordinates; outcome() says whether they
/// may be used. (Summary::ok() would not tell flagged rows.)
struct [[nodiscard]] LiveSummary : BasicSummary {
  /// If not `none`, the row was refused before anything was tried. `status` then says only that the
  /// row failed; describe() gives the reason.
  RowFault fault = RowFault::none;
  std::optional<RowFlag> flag{};  ///< of a row that was solved; empty: proven, or not checked
  PerLevel<double> radius{};      ///< largest, over its scale (LiveRun::scales()); 0: not checked
  double condition = 0;           ///< Certificate::condition; 0: not checked
  /// Report on the way from the last proven row, if there was one. path.time: time up to which the
  /// way is proven [s].
  FollowedStep path{};

  /// Returns whether the row failed because no proven motion leads to it. The formulation may have
  /// solved it or not.
  bool is_unreached() const {
    return status != Status::solved && path.tests > 0 && path.end == PathEnd::stuck;
  }
  Outcome outcome() const {
    return status != Status::solved ? Outcome::failed
           : flag                   ? Outcome::degraded
                                    : Outcome::converged;
  }
};

/// Returns a sentence for people, like that of a Summary; for a refused row, the reason.
std::string describe(const LiveSummary& summary, const Model& model);

/// A run whose driver values are handed in at every step: for a controller, a simulator in a loop
/// or an optimiser.
///
///   const auto formulation = make_formulation(find_variant("group_symbolic_explicit"), model);
///   LiveRun run(*formulation, {.scales = scales});
///   while (read(t, z, zd, zdd)) {
///     const LiveSummary answer = run.step({t, z, zd, zdd});
///     if (answer.outcome() != Outcome::failed) use(run.q(), run.qd(), run.qdd());
///   }
///
/// The motions of the model's drivers are not used: any will do. The values of a row count as
/// exact. Unless CheckMode is `none`, every answer is proven like those of run_checked(), or
/// flagged. The first row is reached from the drawing (find_start()). Between rows the drivers
/// follow the polynomial of lowest degree through both (RowMotions). The proof is that this motion
/// leads from the last proven row to the answer. Where the formulation is on another branch, or
/// finds nothing, the end of the path is the answer, and the formulation goes on from there.
///
/// Outcomes of unusual rows:
/// - NaN, infinity or a wrong size: failed, with a `fault`; nothing was tried
/// - a time that repeats or goes back: failed, with a `fault`; set_time() allows it
/// - values that jump: solved, in sub-steps
/// - values out of reach, in a singular position, beyond one or beyond a change point: failed,
///   since the motion is not proven to lead there
/// - a first row to which no proven way leads from the drawing: degraded, like all until restart()
/// - a first row to which the way passes a change point: degraded, but not the next ones
/// - a first row in a singular position, or where rounding leaves too few digits: degraded
///
/// A row is good unless it failed. After a failure the values are those of the last good row, and
/// the next row starts there. From the second good row on step() allocates nothing, but for
/// libraries of linear algebra. A row of 558 coordinates takes some 0.2 ms.
class LiveRun {
 public:
  /// The formulation must outlive the run, and nothing else may use it. Throws
  /// std::invalid_argument
  /// - for a formulation that needs a motion known in advance (unsupported_live_reason),
  /// - for options that are out of range,
  /// - for `levels` that is neither empty nor has one level for each coordinate,
  /// - for coordinates that are not natural, unless CheckMode is `none`.
  explicit LiveRun(Formulation& formulation, const LiveOptions& options = {});
  ~LiveRun();

  /// Solves a row and, unless CheckMode is `none`, proves or flags it. A row that fails leaves the
  /// last good row as it was.
  LiveSummary step(const LiveRow& row);

  /// Sets the time of the last good position [s], if there is one. The next row may have any later
  /// time.
  void set_time(double t);
  /// Forgets all rows: the next is reached from the drawing.
  void restart();

  /// Returns whether there is a good row.
  bool has_position() const { return has_position_; }
  /// Return the last good row: time [s] and values in coordinate order (Model::coordinates()).
  /// Without a good row, and at levels above that of the options, they are empty or unspecified.
  double time() const { return time_; }
  std::span<const double> q() const { return good_.position; }
  std::span<const double> qd() const { return good_.velocity; }
  std::span<const double> qdd() const { return good_.acceleration; }
  /// Returns bounds on |value − exact| of the last good row, in units of the coordinates; infinite:
  /// no bound is proven.
  const PerLevel<std::vector<double>>& radius() const { return radius_; }
  /// Returns the scales that radii are relative to: those given, or the motion's so far.
  Scales scales() const;

  /// The obstacle to a row that could not be solved.
  struct Obstacle {
    GroupId group = no_position;   ///< group that could not be solved, if known
    int constraint = no_position;  ///< constraint most concerned, if known
    std::optional<Misfit> assembly_error;
    std::optional<TableLock> table_lock{};
  };
  /// Finds what kept the row that was tried last from being solved. Rows with a RowFault were not
  /// tried. Allocates and takes long: call it outside of the loop.
  Obstacle explain() const;

 private:
  struct Checks;

  RowFault fault_of(const LiveRow& row) const;
  Instant solved() const;
  void check(const LiveRow& row, LiveSummary& summary);
  const RefinedInstant* start(const LiveRow& row, LiveSummary& summary);
  const RefinedInstant* follow(const LiveRow& row, LiveSummary& summary);
  const RefinedInstant* return_to(double time, const RefinedInstant& found, LiveSummary& summary);
  void keep(double time, const Instant& instant);
  void go_back();

  Formulation& formulation_;
  LiveOptions options_;  // without levels
  std::unique_ptr<Checks> checks_;
  PerLevel<std::vector<double>> good_, radius_;  // of the last good row
  std::vector<double> tried_;                    // z of the row tried last
  double time_ = 0;                              // s, of the last good row
  bool has_position_ = false;
};

/// Returns why a formulation cannot be driven live, in a sentence without a full stop; empty when
/// it can.
std::string unsupported_live_reason(const Formulation& formulation);

}  // namespace desmo
