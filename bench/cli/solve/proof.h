// desmo solve --certify: what is proven of a motion.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "formulations/verification/certificate/refinement.h"
#include "formulations/verification/monitor/running_scales.h"
#include "formulations/verification/run/branch_path.h"

namespace desmo::cli {

/// Refined instants of a motion, and what is proven of them, summed up.
class Proof {
 public:
  /// levels: of Plan. Model and levels must outlive the proof.
  Proof(const Model& model, const TimeGrid& grid, std::span<const Level> levels);

  /// Returns the instant with corrections where it is proven; valid until the next call.
  Instant refine(const Instant& instant);
  bool is_complete() const { return proven_ == instants_ && followed_ == steps_; }
  /// Returns a line on how many instants are proven, and the largest error bound, relative as in
  /// verification/error.h, and one on the steps that are proven to stay on one branch. Further
  /// lines name the first instant and the first step that are not, if any.
  std::string note(Level level) const;
  /// Returns "group 'SG-II' (rod, slider), t = 2 s: <reason>" of the first instant or step that is
  /// not proven.
  std::string reason() const;

 private:
  void follow(const RefinedInstant& refined);
  std::string reason_of_instant() const;
  std::string reason_of_step() const;

  const Model& m_;
  const std::span<const Level> levels_;
  Refinement refinement_;
  BranchPath path_;
  RunningScales scales_;
  long instants_ = 0, proven_ = 0;
  double first_ = 0;  // time of the first instant not proven
  GroupId group_ = -1;
  ProofFailure failure_ = ProofFailure::none;
  PerLevel<double> length_, rotation_;  // largest radii of proven instants
  long steps_ = 0, followed_ = 0;       // between instants; on one branch
  bool on_path_ = false;                // path_ has the last instant
  double broken_at_ = 0;                // end of the first step that was not followed [s]
  std::optional<FollowedStep> broken_;
};

}  // namespace desmo::cli
