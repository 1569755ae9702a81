#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "formulations/algebra/linear_solver.h"
#include "formulations/equations/pattern.h"

namespace desmo {

/// Dense LU solver. Lu has
///   explicit Lu(int n)
///   double* matrix()      n × n by columns, to be written before factor()
///   bool factor()         overwrites the matrix; false when singular
///   void solve(double* b) b = A⁻¹ b
template <class Lu>
class Dense final : public LinearSolver {
 public:
  explicit Dense(const Pattern& pattern) : n_(pattern.n), lu_(pattern.n) {
    for (int j = 0; j < n_; ++j)
      for (int k = pattern.column_start[j]; k < pattern.column_start[j + 1]; ++k)
        position_.push_back(j * n_ + pattern.row[k]);
  }

  bool factor(const double* values) override {
    double* const matrix = lu_.matrix();
    std::fill_n(matrix, static_cast<std::size_t>(n_) * n_, 0.0);
    for (const int p : position_) matrix[p] = *values++;
    return lu_.factor();
  }

  void solve(double* b) override { lu_.solve(b); }

  /// Returns n/6, at least 3: LU takes n/3 times the operations of a solve, at about twice the
  /// speed.
  int break_even_solves() const override { return std::max(3, n_ / 6); }

 private:
  int n_;
  std::vector<int> position_;  // position of each pattern entry in the matrix
  Lu lu_;
};

}  // namespace desmo
