#pragma once

#include <span>
#include <string_view>

namespace desmo::generate {

/// A header of desmo that generated kernels need.
struct KernelHeader {
  std::string_view text;
  bool for_lanes;  ///< needed only by code for batches
};

/// Returns the headers, each after those it includes. The program contains their text, so that it
/// can compile generated code wherever it is installed.
std::span<const KernelHeader> kernel_headers();

}  // namespace desmo::generate
