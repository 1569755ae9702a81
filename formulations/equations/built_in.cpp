#include "formulations/equations/kernel_sets.h"

namespace desmo {

std::span<const KernelLibrary> built_in_kernels() {
  static const KernelLibrary libraries[] = {
      cases_kernels(),
      cases_explicit_kernels(),
      cases_lane_kernels(FourLanes()),
#ifdef DESMO_LIBRARY_KERNELS
      library_kernels(),
      library_explicit_kernels(),
      library_lane_kernels(FourLanes()),
#endif
#ifdef DESMO_WIDE_LANES
      cases_lane_kernels(EightLanes()),
#ifdef DESMO_LIBRARY_KERNELS
      library_lane_kernels(EightLanes()),
#endif
#endif
  };
  return libraries;
}

}  // namespace desmo
