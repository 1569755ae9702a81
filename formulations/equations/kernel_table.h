#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "formulations/equations/kernel_library.h"

namespace desmo {

/// Generated code that parts can use: added kernels, and those that desmo was built with. Added
/// ones go first: they were made for the mechanism at hand.
class KernelTable {
 public:
  /// Returns the table of the kernels that desmo was built with.
  static const KernelTable& built_in();

  /// Adds a library. It stays in memory as long as this table or a copy of it lives.
  void add(std::shared_ptr<const KernelLibrary> library);

  /// Return the code for a fingerprint (see PartType), or null.
  const Kernel* find_kernel(std::string_view fingerprint) const;
  const ExplicitKernel* find_explicit_kernel(std::string_view fingerprint) const;
  /// Returns the code for a number of lanes; null also where the processor lacks such registers.
  const LaneKernel* find_lane_kernel(std::string_view fingerprint, int lanes) const;

 private:
  template <class K, class IsWanted>
  const K* find(std::span<const K> KernelLibrary::*list, const IsWanted& is_wanted) const;

  std::vector<std::shared_ptr<const KernelLibrary>> added_;
};

}  // namespace desmo
