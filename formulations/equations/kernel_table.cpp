#include "formulations/equations/kernel_table.h"

#include <algorithm>
#include <span>
#include <utility>

#include "formulations/equations/lanes.h"
#include "formulations/equations/symbolic.h"

namespace desmo {

const KernelTable& KernelTable::built_in() {
  static const KernelTable table{};
  return table;
}

void KernelTable::add(std::shared_ptr<const KernelLibrary> library) {
  added_.push_back(std::move(library));
}

template <class K>
const K* KernelTable::find_added(KernelList<K> KernelLibrary::*list,
                                 std::string_view fingerprint) const {
  for (const auto& library : added_) {
    const KernelList<K>& kernels = (*library).*list;
    const std::span<const K> all(kernels.first, kernels.size);
    const auto it = std::ranges::find(all, fingerprint, &K::fingerprint);
    if (it != all.end()) return &*it;
  }
  return nullptr;
}

const Kernel* KernelTable::find_kernel(std::string_view fingerprint) const {
  const Kernel* built = desmo::find_kernel(fingerprint);
  return built ? built : find_added(&KernelLibrary::kernels, fingerprint);
}

const ExplicitKernel* KernelTable::find_explicit_kernel(std::string_view fingerprint) const {
  const ExplicitKernel* built = desmo::find_explicit_kernel(fingerprint);
  return built ? built : find_added(&KernelLibrary::explicit_kernels, fingerprint);
}

const LaneKernel* KernelTable::find_lane_kernel(std::string_view fingerprint) const {
  const LaneKernel* built = desmo::find_lane_kernel(fingerprint);
  return built ? built : find_added(&KernelLibrary::lane_kernels, fingerprint);
}

}  // namespace desmo
