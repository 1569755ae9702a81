#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formulations/formulation.h"
#include "formulations/model/misfit.h"
#include "formulations/model/scales.h"
#include "formulations/verification/branch/start.h"
#include "formulations/verification/certificate/certificate.h"
#include "formulations/verification/run/check_options.h"
#include "formulations/verification/run/table_lock.h"

namespace desmo {

/// Outcome of a checked run, or of one row of a live run.
enum class Outcome {
  converged,  ///< no flag, no gap
  degraded,   ///< a row is flagged, or an interval that cannot be assembled was left out
  failed,     ///< a row has no position (with `past_failures`: none has one), or a strict run met
              ///< a flag
};

/// Reason why the numbers of a row are not proven to be those of the motion in the file.
struct RowFlag {
  /// Kinds of flags, the worst first.
  enum class Kind {
    unproven,  ///< the instant has no proof, or radii that leave no digit: `failure` says why
    branch,    ///< proven, but on an unknown branch since the interval from `after` to `before`:
               ///< a singular position lies there, or the path ran out of tests
    on_point,  ///< the row lies on a change point, or next to it: it has a position and no rates
    crossing,  ///< the step passes a change point, on its smooth continuation, or begins on it. A
               ///< first row has the way from the drawing in place of the step
    misfit,    ///< a left-out equation does not hold at the row, or on the way from the row before:
               ///< there is no exact motion
  };
  Kind kind = Kind::unproven;
  double time = 0;  ///< of the row [s]
  /// Ends of the interval in which the cause lies [s]. For `misfit` both are its time. For a cause
  /// on the way from the drawing both are the time of the first row. `before` is infinite where the
  /// motion stays on or next to a change point. `unproven` may leave both 0.
  double after = 0, before = 0;
  GroupId group = no_position;  ///< of the failed proof, change point or misfit, if known
  bool out_of_tests = false;    ///< branch: the path ran out of tests
  ProofFailure failure = ProofFailure::none;  ///< unproven: why
  std::optional<Misfit> misfit{};             ///< of the row, whatever its flag

  /// Returns whether the motion passes a change point, or is on one.
  bool is_of_change_point() const { return kind == Kind::crossing || kind == Kind::on_point; }
};

/// Replaces a flag by another one if that is worse. The misfit stays.
inline void worsen(std::optional<RowFlag>& flag, RowFlag to) {
  if (flag && flag->kind <= to.kind) return;
  if (flag) to.misfit = flag->misfit;
  flag = to;
}

/// Returns the word for a flag in tables: "unproven", "branch", "misfit" or "crossing".
std::string_view word_of(const RowFlag& flag);

/// A row of a checked run, and what is proven of it.
struct CheckedInstant {
  Instant instant;  ///< with corrections, if it is proven; valid until the next row
  /// Bounds on |instant − exact| of each coordinate. Infinite: there is no proof. Empty: none was
  /// certified.
  PerLevel<std::span<const double>> radius{};
  /// Largest radius over its scale in the motion so far. Infinite: some coordinates have no proof.
  /// 0: `radius` is empty, since the row lies between two that are proven.
  PerLevel<double> relative_radius{};
  double condition = 0;  ///< Certificate::condition; 0: not certified; on a change point infinite
  /// The instant is not the formulation's, which is on another branch or has found none.
  bool is_elsewhere = false;
  bool is_on_point = false;  ///< a mechanism is on a change point, where it has no rates
  /// Worst flag of the row, among its independent mechanisms. Empty: the row is proven or, where
  /// `radius` is empty, lies on the proven step between two checked rows.
  std::optional<RowFlag> flag{};
  std::span<const RowFlag> other_flags{};  ///< of the other mechanisms

  /// Calls a function with each flag, the worst first.
  template <class Call>
  void for_each_flag(const Call& call) const {
    if (flag) call(*flag);
    for (const RowFlag& other : other_flags) call(other);
  }
};

/// Interval in which a mechanism could not be assembled. Its ends are accurate to 1e-9 s or, where
/// that is more, to what rounding of time and of the drivers leaves.
struct Gap {
  double from, to;  ///< [s]
  bool ends;        ///< false: the interval lasts until the end of the run
  /// Status, group, constraint, residual and time of the failure at the interval's first grid
  /// instant. Counts are those of the run up to it.
  Summary failure;
  std::optional<Misfit> assembly_error;   ///< as in CheckedSummary
  std::optional<TableLock> table_lock{};  ///< likewise
};

/// Summary of a checked run: counts, flags and gaps. outcome() says whether its answers may be
/// used.
struct [[nodiscard]] CheckedSummary : BasicSummary {
  bool refused = false;  ///< a strict run ended at a row that is flagged: `first_flag`
  FoundStart::Stage start = FoundStart::Stage::reached;  ///< of the way from the drawing
  long flagged = 0;                                      ///< number of flagged rows
  std::optional<RowFlag> first_flag{};
  long crossings = 0;  ///< number of change points in flags of rows
  std::optional<RowFlag> first_crossing{};
  std::optional<Misfit> misfit{};     ///< the largest of the rows (Misfit::relative)
  Level level = Level::acceleration;  ///< up to which rows are solved
  PerLevel<double> radius{};          ///< largest of proven rows, over `scales`; 0 above `level`
  Scales scales{};                    ///< of the motion
  double condition = 0;               ///< largest of the rows
  /// Status::not_converged: error of the group that cannot be assembled (find_assembly_error()).
  std::optional<Misfit> assembly_error{};
  /// Status::not_finite: position in which a table driven beyond its extremum locks the motion.
  /// Empty: none was found (find_table_lock()), or nothing was checked (CheckMode::none).
  std::optional<TableLock> table_lock{};
  std::vector<Gap> gaps{};  ///< intervals that were left out

  bool ok() const { return status == Status::solved; }  ///< no failure but those in `gaps`
  Outcome outcome() const {
    const bool has_no_row = instants == 0 && !gaps.empty();
    return !ok() || refused || has_no_row ? Outcome::failed
           : flagged > 0 || !gaps.empty() ? Outcome::degraded
                                          : Outcome::converged;
  }
};

/// Settings of a checked run.
struct CheckOptions {
  CheckMode mode = CheckMode::proof;
  int sample = 16;  ///< CheckMode::sample: N, 1 or more
  /// Level requested of each coordinate (Plan::levels); empty: that of the request. The formulation
  /// keeps to it after the run (solve_only()). The memory must last until run_checked() returns.
  std::span<const Level> levels{};
  bool strict = false;         ///< ends at the first flagged row, which is not handed on
  bool past_failures = false;  ///< continues after an interval that cannot be assembled
  /// Callback that receives each row before the observer does; empty: none. It must not throw: it
  /// is called through Observer::observe(), where an exception ends the program.
  std::function<void(const CheckedInstant&)> checked{};
};

/// Runs a motion like Formulation::run() and proves it. Each number that the observer receives is
/// within its radius of the exact motion of the mechanism in the file, or its row's flag says why
/// not. That motion is on the branch of the drawing, continued smoothly through change points that
/// are flagged. Certificates correct each instant (Refinement), path proofs follow each step
/// (BranchPath). Where the formulation finds another branch, or nothing, the end of the path is
/// delivered, and the formulation goes on from there.
///
/// The run ends, as a failure, where there is no position. All instants before it were delivered.
/// With `past_failures` it continues at the next instant that can be assembled.
/// Throws std::invalid_argument
/// - for a request that names coordinates,
/// - for coordinates that are not natural, unless CheckMode is `none`,
/// - for `levels` that is neither empty nor has one level for each coordinate,
/// - for a `sample` below 1 that CheckMode::sample uses.
///
///   const auto formulation = make_formulation(find_variant("block_symbolic_inlined"), model);
///   const CheckedSummary s = run_checked(*formulation, grid, {Level::acceleration}, observer);
///   if (s.outcome() != Outcome::converged) std::cerr << describe(s, model);
CheckedSummary run_checked(Formulation& formulation, const TimeGrid& grid, const Request& request,
                           Observer& observer, const CheckOptions& options = {});

/// Returns the outcome in a line. On failure: what failed when and where, and what was flagged
/// before. Otherwise: what was flagged first, and the largest radii.
std::string describe(const CheckedSummary& summary, const Model& model);

/// Returns the largest radii in words, up to CheckedSummary::level, rounded up: "condition 4.1e+02,
/// errors at most 3.2e-13, 1.1e-11 in velocity, 7.3e-11 in acceleration".
std::string describe_radius(const CheckedSummary& summary);

}  // namespace desmo
