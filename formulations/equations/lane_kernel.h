#pragma once

#include <array>
#include <span>
#include <string_view>

#include "formulations/equations/explicit_kernel.h"

namespace desmo {

/// How many parts of one type may be solved at once: what registers of 256 and of 512 bits hold.
inline constexpr std::array lane_counts{4, 8};
inline constexpr int max_lanes = lane_counts.back();

/// Where an explicit order ended in several lanes.
struct LaneResult {
  unsigned accepted;  ///< bit l: ExplicitResult::accepted of lane l
  int iterations;     ///< the most of any lane
};

/// An explicit kernel for as many parts as there are lanes. Its arrays hold LaneValues of the local
/// inputs, a part in each lane, the binding's too. They are numbers and not registers, for its code
/// may be compiled for another processor than what calls it. Rates are solved to accelerations.
struct LaneKernel {
  int lanes;
  std::string_view fingerprint;   ///< PartType::fingerprint
  std::span<const int> read;      ///< local inputs: of its own unknowns the last position alone
  std::span<const int> unknowns;  ///< those that are written
  /// residual2: as many as lanes, ExplicitResult::residual2 of each.
  LaneResult (*solve)(double* q, double* qd, double* qdd, const ExplicitBinding<double>& parts,
                      double* residual2);
};

/// Whether this build has code for so many lanes, and this processor registers.
bool has_lanes(int lanes);

/// The kernel that desmo was built with for a fingerprint and so many lanes, which the processor
/// has, or null.
const LaneKernel* find_lane_kernel(std::string_view fingerprint, int lanes);

}  // namespace desmo
