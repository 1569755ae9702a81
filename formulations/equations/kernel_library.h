#pragma once

#include <span>

#include "formulations/equations/explicit_kernel.h"
#include "formulations/equations/kernel.h"
#include "formulations/equations/lane_kernel.h"

namespace desmo {

/// Compiled kernels: of a set that desmo was built with, or of a file that it loads, whose exported
/// object `desmo_kernels` has this type.
struct KernelLibrary {
  std::span<const Kernel> kernels = {};
  std::span<const ExplicitKernel> explicit_kernels = {};
  std::span<const LaneKernel> lane_kernels = {};
};

}  // namespace desmo
