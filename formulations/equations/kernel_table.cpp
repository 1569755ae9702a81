#include "formulations/equations/kernel_table.h"

#include <algorithm>
#include <utility>

#include "formulations/equations/kernel_sets.h"

namespace desmo {

bool has_lanes(int lanes) {
  if (lanes == 4) return true;  // every build has them, in narrower registers if need be
#ifdef DESMO_WIDE_LANES
  if (lanes == 8)  // the instructions of x86-64-v4
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
#endif
  return false;
}

const KernelTable& KernelTable::built_in() {
  static const KernelTable table{};
  return table;
}

void KernelTable::add(std::shared_ptr<const KernelLibrary> library) {
  added_.push_back(std::move(library));
}

template <class K, class IsWanted>
const K* KernelTable::find(std::span<const K> KernelLibrary::*list,
                           const IsWanted& is_wanted) const {
  const auto find_in = [&](const KernelLibrary& library) {
    const std::span<const K> kernels = library.*list;
    const auto it = std::ranges::find_if(kernels, is_wanted);
    return it == kernels.end() ? nullptr : &*it;
  };
  for (const auto& library : added_)
    if (const K* const kernel = find_in(*library)) return kernel;
  for (const KernelLibrary& library : built_in_kernels())
    if (const K* const kernel = find_in(library)) return kernel;
  return nullptr;
}

const Kernel* KernelTable::find_kernel(std::string_view fingerprint) const {
  return find(&KernelLibrary::kernels,
              [&](const Kernel& kernel) { return kernel.fingerprint == fingerprint; });
}

const ExplicitKernel* KernelTable::find_explicit_kernel(std::string_view fingerprint) const {
  return find(&KernelLibrary::explicit_kernels,
              [&](const ExplicitKernel& kernel) { return kernel.fingerprint == fingerprint; });
}

const LaneKernel* KernelTable::find_lane_kernel(std::string_view fingerprint, int lanes) const {
  if (!has_lanes(lanes)) return nullptr;
  return find(&KernelLibrary::lane_kernels, [&](const LaneKernel& kernel) {
    return kernel.lanes == lanes && kernel.fingerprint == fingerprint;
  });
}

}  // namespace desmo
