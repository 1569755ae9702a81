#include <unordered_map>

#include "formulations/equations/kernel_sets.h"
#include "formulations/equations/symbolic.h"

namespace desmo {

namespace {

/// Finds a kernel by its fingerprint in one table of all sets.
template <auto table>
auto find(std::string_view fingerprint) {
  static const auto by_fingerprint = [] {
    std::unordered_map<std::string_view, decltype((KernelTables{}.*table).data())> map;
    for (const KernelTables& set : built_in_kernels())
      for (const auto& kernel : set.*table) map.emplace(kernel.fingerprint, &kernel);
    return map;
  }();
  const auto it = by_fingerprint.find(fingerprint);
  return it == by_fingerprint.end() ? nullptr : it->second;
}

}  // namespace

const Kernel* find_kernel(std::string_view fingerprint) {
  return find<&KernelTables::kernels>(fingerprint);
}

const ExplicitKernel* find_explicit_kernel(std::string_view fingerprint) {
  return find<&KernelTables::explicit_kernels>(fingerprint);
}

bool has_lanes(int lanes) {
  if (lanes == 4) return true;  // what everything is compiled for, or what the compiler makes of it
#ifdef DESMO_WIDE_LANES
  if (lanes == 8)  // x86-64-v4
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
#endif
  return false;
}

const LaneKernel* find_lane_kernel(std::string_view fingerprint, int lanes) {
  if (!has_lanes(lanes)) return nullptr;
  return lanes == 8 ? find<&KernelTables::eight_lanes>(fingerprint)
                    : find<&KernelTables::four_lanes>(fingerprint);
}

}  // namespace desmo
