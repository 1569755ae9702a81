// desmo solve --certify: what is proven of a motion.
#pragma once

#include <span>
#include <string>

#include "formulations/verification/certificate/refinement.h"
#include "formulations/verification/monitor/running_scales.h"

namespace desmo::cli {

/// Refined instants of a motion, and what is proven of them, summed up.
class Proof {
 public:
  /// levels: of Plan. Model and levels must outlive the proof.
  Proof(const Model& model, const TimeGrid& grid, std::span<const Level> levels);

  /// Returns the instant with corrections where it is proven; valid until the next call.
  Instant refine(const Instant& instant);
  bool is_complete() const { return proven_ == instants_; }
  /// Returns a line on how many instants are proven, and the largest error bound, relative as in
  /// verification/error.h. A further line names the first instant that is not proven, if any.
  std::string note(Level level) const;
  /// Returns "group 'SG-II' (rod, slider), t = 2 s: <reason>" of the first one not proven.
  std::string reason() const;

 private:
  const Model& m_;
  Refinement refinement_;
  RunningScales scales_;
  long instants_ = 0, proven_ = 0;
  double first_ = 0;  // time of the first instant not proven
  GroupId group_ = -1;
  ProofFailure failure_ = ProofFailure::none;
  PerLevel<double> length_, rotation_;  // largest radii of proven instants
};

}  // namespace desmo::cli
