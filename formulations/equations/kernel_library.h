#pragma once

#include <cstddef>

#include "formulations/equations/explicit_kernel.h"
#include "formulations/equations/kernel.h"

namespace desmo {

struct LaneKernel;

template <class Kernel>
struct KernelList {
  const Kernel* first = nullptr;
  std::size_t size = 0;
};

/// Content of a file of compiled kernels: the type of its exported object `desmo_kernels`.
struct KernelLibrary {
  KernelList<Kernel> kernels;
  KernelList<ExplicitKernel> explicit_kernels;
  KernelList<LaneKernel> lane_kernels;
};

}  // namespace desmo
