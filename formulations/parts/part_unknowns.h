#pragma once

#include <span>
#include <vector>

#include "formulations/base/index_range.h"

namespace desmo {

/// The positions of a part's unknowns in the state.
class PartUnknowns {
 public:
  /// unknowns: their positions in the state, ascending; the array outlives this object.
  explicit PartUnknowns(std::span<const int> unknowns)
      : unknowns_(unknowns), ranges_(ranges_of(unknowns)) {
    // minimum mean length of ranges (≥): loops over shorter ones cost more than looking indices up
    constexpr std::size_t min_mean = 8;
    if (ranges_.size() * min_mean > unknowns.size()) ranges_.clear();
  }

  /// Calls call(position in the state, k) for each unknown k. Loops over long ranges fit wide
  /// registers.
  template <class Call>
  [[gnu::always_inline]] void for_each(Call call) const {
    const int n = static_cast<int>(unknowns_.size());
    if (ranges_.empty())
      for (int i = 0; i < n; ++i) call(unknowns_[i], i);
    int i = 0;
    for (const IndexRange range : ranges_) {
      const int shift = i - range.first;
      for (int at = range.first; at < range.end; ++at) call(at, at + shift);
      i += range.end - range.first;
    }
  }

 private:
  std::span<const int> unknowns_;
  std::vector<IndexRange> ranges_;
};

}  // namespace desmo
