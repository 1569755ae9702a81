#pragma once

#include <span>

#include "formulations/equations/explicit_kernel.h"
#include "formulations/equations/kernel.h"
#include "formulations/equations/lane_kernel.h"

namespace desmo {

/// Mechanisms whose kernels are generated together when desmo is built. A type of group that occurs
/// in both sets has its kernels in the first.
enum class KernelSet {
  cases,    ///< the paper's two cases and the requests in cases/requests
  library,  ///< the mechanisms of cases/library
};

/// Return the generated kernels of a set. Kernels for 8 lanes exist only in builds with
/// DESMO_WIDE_LANES.
template <KernelSet>
std::span<const Kernel> kernels();
template <KernelSet>
std::span<const ExplicitKernel> explicit_kernels();
template <KernelSet, int lanes>
std::span<const LaneKernel> lane_kernels();
template <>
std::span<const Kernel> kernels<KernelSet::cases>();
template <>
std::span<const ExplicitKernel> explicit_kernels<KernelSet::cases>();
template <>
std::span<const LaneKernel> lane_kernels<KernelSet::cases, 4>();
template <>
std::span<const LaneKernel> lane_kernels<KernelSet::cases, 8>();
template <>
std::span<const Kernel> kernels<KernelSet::library>();
template <>
std::span<const ExplicitKernel> explicit_kernels<KernelSet::library>();
template <>
std::span<const LaneKernel> lane_kernels<KernelSet::library, 4>();
template <>
std::span<const LaneKernel> lane_kernels<KernelSet::library, 8>();

/// Tables of one set.
struct KernelTables {
  std::span<const Kernel> kernels;
  std::span<const ExplicitKernel> explicit_kernels;
  std::span<const LaneKernel> four_lanes, eight_lanes;
};

/// Returns the tables of all sets that the program was linked with. A program links either
/// desmo_kernels (both sets) or desmo_case_kernels (the first alone).
std::span<const KernelTables> built_in_kernels();

}  // namespace desmo
