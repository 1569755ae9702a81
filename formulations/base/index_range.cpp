#include "formulations/base/index_range.h"

namespace desmo {

std::vector<IndexRange> ranges_of(std::span<const int> coordinates) {
  std::vector<IndexRange> runs;
  for (const int i : coordinates) {
    if (runs.empty() || runs.back().end != i) runs.push_back({i, i});
    ++runs.back().end;
  }
  return runs;
}

}  // namespace desmo
