#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace desmo {

/// Numbers 0 … size − 1 in sets that can be united (union–find with path halving).
class DisjointSets {
 public:
  /// Puts every number in a set of its own.
  explicit DisjointSets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /// Returns the number that stands for the set of x.
  int find(int x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  /// Unites the sets of x and y. The number that stood for the set of y stands for both.
  void unite(int x, int y) { parent_[find(x)] = find(y); }

 private:
  std::vector<int> parent_;
};

}  // namespace desmo
