#pragma once

#include <array>
#include <span>
#include <string_view>

#include "formulations/equations/explicit_kernel.h"

namespace desmo {

/// Numbers of parts of one type that can be solved at once, in registers of 256 and 512 bits.
inline constexpr std::array lane_counts{4, 8};
inline constexpr int max_lanes = lane_counts.back();

/// Result of an explicit order in several lanes.
struct LaneResult {
  unsigned accepted;  ///< bit l: ExplicitResult::accepted of lane l
  int iterations;     ///< largest ExplicitResult::iterations of a lane
};

/// An explicit kernel that solves one part in each lane. All arrays but ExplicitBinding::in hold
/// the lanes of each number side by side. They are passed as doubles, not as registers: the kernel
/// may be compiled for another processor than its caller. Rates are solved up to accelerations.
struct LaneKernel {
  int lanes;
  std::string_view fingerprint;  ///< PartType::fingerprint
  /// local inputs that it reads: all that are not unknowns, and of the unknowns the torn ones and
  /// the unwrapped angles
  std::span<const int> read;
  std::span<const int> unknowns;  ///< local inputs that it writes
  /// Solves the parts. residual2: (lanes), ExplicitResult::residual2 of each.
  LaneResult (*solve)(double* q, double* qd, double* qdd, const ExplicitBinding<double>& parts,
                      double* residual2);
};

/// Returns whether this build has code for a number of lanes and this processor the registers.
bool has_lanes(int lanes);

}  // namespace desmo
