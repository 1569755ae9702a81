#pragma once

#include <span>
#include <vector>

namespace desmo {

/// Consecutive indices: what is done to all is done without looking any up.
struct IndexRange {
  int first, end;
};

/// Returns ascending indices as ranges.
inline std::vector<IndexRange> ranges_of(std::span<const int> indices) {
  std::vector<IndexRange> ranges;
  for (const int i : indices) {
    if (ranges.empty() || ranges.back().end != i) ranges.push_back({i, i});
    ++ranges.back().end;
  }
  return ranges;
}

}  // namespace desmo
