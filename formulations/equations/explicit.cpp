#include <unordered_map>

#include "formulations/equations/explicit_kernel.h"
#include "formulations/equations/lane_kernel.h"

namespace desmo {

namespace {

/// In the table that a function gives.
template <auto table>
auto find(std::string_view fingerprint) {
  static const auto by_fingerprint = [] {
    std::unordered_map<std::string_view, decltype(table().data())> map;
    for (const auto& kernel : table()) map.emplace(kernel.fingerprint, &kernel);
    return map;
  }();
  const auto it = by_fingerprint.find(fingerprint);
  return it == by_fingerprint.end() ? nullptr : it->second;
}

}  // namespace

const ExplicitKernel* find_explicit_kernel(std::string_view fingerprint) {
  return find<&explicit_kernels>(fingerprint);
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
#ifdef DESMO_WIDE_LANES
  if (lanes == 8) return find<&lane_kernels<8>>(fingerprint);
#endif
  return find<&lane_kernels<4>>(fingerprint);
}

}  // namespace desmo
