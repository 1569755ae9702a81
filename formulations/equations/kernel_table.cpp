#include "formulations/equations/kernel_table.h"

#include <algorithm>
#include <span>
#include <utility>

#include "formulations/equations/lane_kernel.h"
#include "formulations/equations/symbolic.h"

namespace desmo {

namespace {

auto is_named(std::string_view fingerprint) {
  return [=](const auto& kernel) { return kernel.fingerprint == fingerprint; };
}

}  // namespace

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
  const Kernel* built = desmo::find_kernel(fingerprint);
  return built ? built : find_added(&KernelLibrary::kernels, is_named(fingerprint));
}

const ExplicitKernel* KernelTable::find_explicit_kernel(std::string_view fingerprint) const {
  const ExplicitKernel* built = desmo::find_explicit_kernel(fingerprint);
  return built ? built : find_added(&KernelLibrary::explicit_kernels, is_named(fingerprint));
}

const LaneKernel* KernelTable::find_lane_kernel(std::string_view fingerprint, int lanes) const {
  const LaneKernel* built = desmo::find_lane_kernel(fingerprint, lanes);
  if (built || !has_lanes(lanes)) return built;
  return find_added(&KernelLibrary::lane_kernels, [&](const LaneKernel& kernel) {
    return kernel.lanes == lanes && kernel.fingerprint == fingerprint;
  });
}

}  // namespace desmo
