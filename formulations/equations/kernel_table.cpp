#include "formulations/equations/kernel_table.h"

#include <algorithm>
#include <span>
#include <unordered_map>
#include <utility>

#include "formulations/equations/kernel_sets.h"
#include "formulations/equations/lane_kernel.h"

namespace desmo {

namespace {

/// Finds a kernel by its fingerprint in one table of all sets that desmo was built with.
template <auto table>
auto find_built_in(std::string_view fingerprint) {
  static const auto by_fingerprint = [] {
    std::unordered_map<std::string_view, decltype((KernelTables{}.*table).data())> map;
    for (const KernelTables& set : built_in_kernels())
      for (const auto& kernel : set.*table) map.emplace(kernel.fingerprint, &kernel);
    return map;
  }();
  const auto it = by_fingerprint.find(fingerprint);
  return it == by_fingerprint.end() ? nullptr : it->second;
}

auto is_named(std::string_view fingerprint) {
  return [=](const auto& kernel) { return kernel.fingerprint == fingerprint; };
}

}  // namespace

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

const KernelTable& KernelTable::built_in() {
  static const KernelTable table{};
  return table;
}

void KernelTable::add(std::shared_ptr<const KernelLibrary> library) {
  added_.push_back(std::move(library));
}

template <class K, class IsWanted>
const K* KernelTable::find_added(KernelList<K> KernelLibrary::*list,
                                 const IsWanted& is_wanted) const {
  for (const auto& library : added_) {
    const KernelList<K>& kernels = (*library).*list;
    const std::span<const K> all(kernels.first, kernels.size);
    const auto it = std::ranges::find_if(all, is_wanted);
    if (it != all.end()) return &*it;
  }
  return nullptr;
}

const Kernel* KernelTable::find_kernel(std::string_view fingerprint) const {
  const Kernel* built = find_built_in<&KernelTables::kernels>(fingerprint);
  return built ? built : find_added(&KernelLibrary::kernels, is_named(fingerprint));
}

const ExplicitKernel* KernelTable::find_explicit_kernel(std::string_view fingerprint) const {
  const ExplicitKernel* built = find_built_in<&KernelTables::explicit_kernels>(fingerprint);
  return built ? built : find_added(&KernelLibrary::explicit_kernels, is_named(fingerprint));
}

const LaneKernel* KernelTable::find_lane_kernel(std::string_view fingerprint, int lanes) const {
  if (!has_lanes(lanes)) return nullptr;
  const LaneKernel* built = lanes == 8 ? find_built_in<&KernelTables::eight_lanes>(fingerprint)
                                       : find_built_in<&KernelTables::four_lanes>(fingerprint);
  if (built) return built;
  return find_added(&KernelLibrary::lane_kernels, [&](const LaneKernel& kernel) {
    return kernel.lanes == lanes && kernel.fingerprint == fingerprint;
  });
}

}  // namespace desmo
