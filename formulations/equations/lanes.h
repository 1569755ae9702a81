#pragma once

#include <experimental/simd>
#include <span>
#include <string_view>

#include "formulations/equations/explicit_kernel.h"

namespace desmo {

/// How many parts of one type are solved at once: what 256-bit registers hold.
inline constexpr int lane_count = 4;
using Lanes = std::experimental::simd<
    double, std::experimental::simd_abi::deduce_t<double, static_cast<std::size_t>(lane_count)>>;

/// An explicit kernel for as many parts as there are lanes. Its arrays are those of the local
/// inputs, a part in each lane. Rates are solved to accelerations.
struct LaneKernel {
  std::string_view fingerprint;    ///< PartType::fingerprint
  std::span<const int> positions;  ///< local inputs of which the position is read
  std::span<const int> rates;      ///< of which velocity and acceleration are
  std::span<const int> unknowns;   ///< those that are written
  ExplicitResult<Lanes> (*solve)(Lanes* q, Lanes* qd, Lanes* qdd,
                                 const ExplicitBinding<Lanes>& parts);
};

/// Every generated lane kernel.
std::span<const LaneKernel> lane_kernels();

/// The lane kernel that desmo was built with for a fingerprint, or null.
const LaneKernel* find_lane_kernel(std::string_view fingerprint);

}  // namespace desmo
