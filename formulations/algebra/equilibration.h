#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>
#include <vector>

#include "formulations/algebra/linear_solver.h"
#include "formulations/equations/pattern.h"

namespace desmo {

/// Linear systems with Φ_φ, solved with factors of the scaled matrix R Φ_φ S. R and S are diagonal:
/// R divides equations by their magnitudes, S measures unknowns in theirs. So pivots compare the
/// same way in nanometres, in gigametres and with both in one part, and overflow is avoided. The
/// diagonals are rounded to powers of two, so that scaling rounds nothing. Where all magnitudes are
/// near 1, R and S are omitted.
class Equilibration {
 public:
  /// weights: 1/magnitude of each equation. magnitudes: those of the unknowns; empty: all are 1.
  Equilibration(const Pattern& pattern, std::span<const double> weights,
                std::span<const double> magnitudes) {
    if (are_ordinary(weights) && are_ordinary(magnitudes)) return;
    for (const double w : weights) row_.push_back(std::ldexp(1.0, std::ilogb(w)));
    for (const double m : magnitudes) column_.push_back(std::ldexp(1.0, std::ilogb(m)));
    column_.resize(pattern.n, 1.0);
    for (int j = 0; j < pattern.n; ++j)
      for (int k = pattern.column_start[j]; k < pattern.column_start[j + 1]; ++k)
        entries_.push_back({pattern.row[k], j});
    scaled_.resize(entries_.size());
  }

  /// Returns R Φ_φ S. Valid until the next call and as long as `values` is.
  [[gnu::always_inline]] const double* matrix(const double* values) {
    return entries_.empty() ? values : scaled_matrix(values);
  }

  /// Overwrites b with Φ_φ⁻¹ b = S (R Φ_φ S)⁻¹ R b, by a solver that has factors of matrix().
  [[gnu::always_inline]] void solve(LinearSolver& solver, double* b) const {
    row_.empty() ? solver.solve(b) : solve_scaled(solver, b);
  }

  /// Like solve(), by LinearSolver::solve_closures().
  void solve_closures(LinearSolver& solver, double* b) const {
    for (std::size_t i = 0; i < row_.size(); ++i) b[i] *= row_[i];
    solver.solve_closures(b);
    for (std::size_t j = 0; j < column_.size(); ++j) b[j] *= column_[j];
  }

 private:
  struct Entry {
    int row, column;
  };

  // Kept out of line, so that the common case without scaling is inlined.
  [[gnu::noinline]] const double* scaled_matrix(const double* values) {
    for (std::size_t k = 0; k < entries_.size(); ++k)
      scaled_[k] = row_[entries_[k].row] * values[k] * column_[entries_[k].column];
    return scaled_.data();
  }

  [[gnu::noinline]] void solve_scaled(LinearSolver& solver, double* b) const {
    for (std::size_t i = 0; i < row_.size(); ++i) b[i] *= row_[i];
    solver.solve(b);
    for (std::size_t j = 0; j < column_.size(); ++j) b[j] *= column_[j];
  }

  static bool are_ordinary(std::span<const double> numbers) {
    constexpr int ordinary = 10;  // maximum |binary exponent| (≤)
    return std::ranges::all_of(numbers,
                               [](double x) { return std::abs(std::ilogb(x)) <= ordinary; });
  }

  std::vector<double> row_, column_;  // powers of two, diagonals of R and S; empty: all are 1
  std::vector<Entry> entries_;        // row and column of each entry of Φ_φ
  std::vector<double> scaled_;
};

}  // namespace desmo
