#pragma once

#include <algorithm>
#include <span>
#include <vector>

namespace desmo {

/// The consecutive indices first … end − 1. A loop over a range reads no list of indices.
struct IndexRange {
  int first, end;
};

/// Returns the fewest ranges that hold these indices, which ascend and are all different.
inline std::vector<IndexRange> ranges_of(std::span<const int> indices) {
  std::vector<IndexRange> ranges;
  for (const int i : indices) {
    if (ranges.empty() || ranges.back().end != i) ranges.push_back({i, i});
    ++ranges.back().end;
  }
  return ranges;
}

/// Returns the position of an index among ascending ones, or −1.
inline int position_in(std::span<const int> ascending, int index) {
  const auto it = std::ranges::lower_bound(ascending, index);
  return it != ascending.end() && *it == index ? static_cast<int>(it - ascending.begin()) : -1;
}

}  // namespace desmo
