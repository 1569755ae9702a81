#pragma once

#include <algorithm>
#include <vector>

#include "formulations/equations/pattern.h"

namespace desmo {

/// Writes a part's Φ_φ into a dense matrix, stored by columns.
class DenseScatter {
 public:
  explicit DenseScatter(const Pattern& pattern) : n_(pattern.n) {
    for (int j = 0; j < n_; ++j)
      for (int k = pattern.column_start[j]; k < pattern.column_start[j + 1]; ++k)
        position_.push_back(j * n_ + pattern.row[k]);
  }

  /// matrix: n × n, overwritten.
  void operator()(const double* values, double* matrix) const {
    std::fill_n(matrix, static_cast<std::size_t>(n_) * n_, 0.0);
    for (const int p : position_) matrix[p] = *values++;
  }

 private:
  int n_;
  std::vector<int> position_;  // of each entry of the pattern
};

}  // namespace desmo
