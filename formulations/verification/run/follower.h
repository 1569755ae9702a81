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

/// Follower of a motion by one choice of equations: refinement, path proofs, equations left out.
struct Follower {
  /// - chosen: equations that were chosen anew; null: the model's
  /// - model, levels: of Refinement
  /// - budget: of BranchPath
  Follower(std::unique_ptr<const Model> chosen, const Model& model, std::span<const Level> levels,
           int budget = BranchPath::max_tests);
  Follower(const Follower&) = delete;
  Follower& operator=(const Follower&) = delete;

  /// Returns the flag, but for its row's time, of a row where an equation that was left out does
  /// not hold, or does not on the way from the last row; nothing where all do. What left_out has
  /// noted on that way it forgets.
  /// - refined: the row's instant
  /// - live: row that was handed in, whose time is 0 in the path; null: the model's motions drive
  std::optional<RowFlag> misfit_flag(const RefinedInstant& refined, const LiveRow* live = nullptr);

  std::unique_ptr<const Model> chosen;
  const Model& model;
  Refinement refinement;
  BranchPath path;
  LeftOutEquations left_out;
  std::unique_ptr<StraightPath> straight{};  ///< null: not needed so far
};

/// Returns the flag of a first row [s]: of a crossing, or of an unknown branch, on the way to it.
RowFlag start_flag(RowFlag::Kind kind, const FoundStart& start, double time);

}  // namespace desmo
