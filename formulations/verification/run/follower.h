#pragma once

#include <memory>
#include <optional>
#include <span>

#include "formulations/verification/branch/branch_path.h"
#include "formulations/verification/branch/left_out_equations.h"
#include "formulations/verification/branch/start.h"
#include "formulations/verification/branch/straight_path.h"
#include "formulations/verification/certificate/refinement.h"
#include "formulations/verification/run/checked_run.h"

namespace desmo {

/// Follower of a motion by one choice of equations: refinement, path and left-out equations.
struct Follower {
  /// - chosen: model with equations that were chosen anew; null: `model` is followed
  /// - levels: see Refinement
  /// - budget: see BranchPath
  Follower(std::unique_ptr<const Model> chosen, const Model& model, std::span<const Level> levels,
           int budget = BranchPath::max_tests);
  Follower(const Follower&) = delete;
  Follower& operator=(const Follower&) = delete;

  /// Flags a row if a left-out equation does not hold there, or on the way from the row before.
  /// Forgets the misfit that left_out has noted on the way.
  /// - refined: the row's instant
  /// - flag: of the row. Another flag keeps its kind and gets the misfit, too. In a new one, the
  ///   caller sets RowFlag::time.
  /// - live: row that was handed in, whose time is 0 in `path`; null: the model's motions drive
  void flag_misfit(const RefinedInstant& refined, std::optional<RowFlag>& flag,
                   const LiveRow* live = nullptr);

  std::unique_ptr<const Model> chosen;
  const Model& model;
  Refinement refinement;
  BranchPath path;
  LeftOutEquations left_out;
  /// Finds positions on a change point. Null: the motion is on none, or no row has needed it yet.
  std::unique_ptr<StraightPath> straight{};
};

/// Returns the flag of the first row, at a time [s]. The way to it from the drawing passed a change
/// point (crossing), or is blocked (branch).
RowFlag start_flag(RowFlag::Kind kind, const FoundStart& start, double time);

}  // namespace desmo
