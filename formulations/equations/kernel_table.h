#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "formulations/equations/kernel_library.h"

namespace desmo {

/// The generated code that parts may be made of: what desmo was built with, and where that has
/// nothing, what was added.
class KernelTable {
 public:
  /// What desmo was built with.
  static const KernelTable& built_in();

  /// The library stays in memory as long as this table or a copy of it lives.
  void add(std::shared_ptr<const KernelLibrary> library);

  /// The code for a fingerprint (see PartType), or null.
  const Kernel* find_kernel(std::string_view fingerprint) const;
  const ExplicitKernel* find_explicit_kernel(std::string_view fingerprint) const;
  /// For so many lanes; null, too, where the processor has none so wide.
  const LaneKernel* find_lane_kernel(std::string_view fingerprint, int lanes) const;

 private:
  template <class K, class IsWanted>
  const K* find_added(KernelList<K> KernelLibrary::*list, const IsWanted& is_wanted) const;

  std::vector<std::shared_ptr<const KernelLibrary>> added_;
};

}  // namespace desmo
