#pragma once

#include <span>
#include <vector>

namespace desmo {

/// Coordinates that stand together: what is done to all is done without looking any up.
struct IndexRange {
  int first, end;
};

/// Ascending coordinates as runs.
std::vector<IndexRange> ranges_of(std::span<const int> coordinates);

}  // namespace desmo
