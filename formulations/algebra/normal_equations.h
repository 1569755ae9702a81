#pragma once

#include <vector>

#include "formulations/equations/pattern.h"

namespace desmo {

/// The upper triangle of N = Φ_φᵀ Φ_φ with rows and columns permuted, refilled without searching:
/// each entry is a sum of products of pairs of entries of Φ_φ, listed once.
class NormalEquations {
 public:
  /// permutation[k] is the column of Φ_φ that becomes column k of N.
  NormalEquations(const Pattern& pattern, const std::vector<int>& permutation);

  int n() const { return n_; }
  std::vector<int>& column_start() { return column_start_; }  ///< n + 1
  std::vector<int>& row() { return row_; }                    ///< ascending within a column
  std::vector<double>& values() { return values_; }

  /// values() = N of these values of Φ_φ, overwritten.
  void refill(const double* jacobian);
  /// y = P Φ_φᵀ b, overwritten.
  void transposed_product(const double* jacobian, const double* b, double* y) const;
  /// x = Pᵀ y, overwritten.
  void unpermute(const double* y, double* x) const;

 private:
  int n_;
  std::vector<int> permutation_;
  std::vector<int> jacobian_start_, jacobian_row_;
  std::vector<int> column_start_, row_;
  std::vector<double> values_;
  struct Pair {
    int a, b;  // positions in the values of Φ_φ
  };
  std::vector<Pair> pairs_;      // of all entries of N, in order
  std::vector<int> pair_start_;  // of each entry of N, and the end
};

}  // namespace desmo
