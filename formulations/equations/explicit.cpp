#include <unordered_map>

#include "formulations/equations/explicit_kernel.h"
#include "formulations/equations/lanes.h"

namespace desmo {

namespace {

template <class Kernel>
const Kernel* find(std::span<const Kernel> kernels, std::string_view fingerprint) {
  static const auto by_fingerprint = [kernels] {
    std::unordered_map<std::string_view, const Kernel*> map;
    for (const Kernel& k : kernels) map.emplace(k.fingerprint, &k);
    return map;
  }();
  const auto it = by_fingerprint.find(fingerprint);
  return it == by_fingerprint.end() ? nullptr : it->second;
}

}  // namespace

const ExplicitKernel* find_explicit_kernel(std::string_view fingerprint) {
  return find(explicit_kernels(), fingerprint);
}

const LaneKernel* find_lane_kernel(std::string_view fingerprint) {
  return find(lane_kernels(), fingerprint);
}

}  // namespace desmo
