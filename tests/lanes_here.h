#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "formulations/equations/lane_kernel.h"

namespace desmo {

/// Returns the lane counts that this build has code for and this processor has registers for.
inline std::vector<int> lanes_here() {
  std::vector<int> result;
  std::ranges::copy_if(lane_counts, std::back_inserter(result), has_lanes);
  return result;
}

}  // namespace desmo
