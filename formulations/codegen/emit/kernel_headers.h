#pragma once

#include <span>
#include <string_view>

namespace desmo::generate {

/// The text of a header of desmo that generated kernels include.
struct KernelHeader {
  std::string_view text;
  bool for_lanes;  ///< only code for lanes needs it
};

/// Each after those that it includes itself. They are in the program so that it can have code
/// compiled wherever it is installed.
std::span<const KernelHeader> kernel_headers();

}  // namespace desmo::generate
