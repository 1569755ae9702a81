#pragma once

#include <vector>

#include "formulations/algebra/sums_of_products.h"
#include "formulations/equations/pattern.h"

namespace desmo {

/// Form of the normal equations of Φ_φ x = b; the fill-in of the two differs.
enum class NormalForm {
  columns,  ///< Φ_φᵀ Φ_φ x = Φ_φᵀ b
  rows,     ///< Φ_φ Φ_φᵀ y = b, x = Φ_φᵀ y
};

/// Upper triangle of N = P Φ_φᵀ Φ_φ Pᵀ or P Φ_φ Φ_φᵀ Pᵀ, with a permutation matrix P. Each entry is
/// a sum of products of entries of Φ_φ, found once: refilling needs no search.
class NormalEquations {
 public:
  /// permutation[k]: column or row of Φ_φ that becomes column k of N; empty: they keep their order.
  NormalEquations(const Pattern& pattern, NormalForm form, std::vector<int> permutation = {});

  int n() const { return n_; }
  /// Returns the first entry of each column, and the end (n + 1).
  std::vector<int>& column_start() { return column_start_; }
  std::vector<int>& row() { return row_; }  ///< row of each entry, ascending within a column
  std::vector<double>& values() { return values_; }

  /// Overwrites values() with N of these values of Φ_φ.
  void refill(const double* jacobian);
  /// Overwrites right (n) with P Φ_φᵀ b (columns) or P b (rows).
  void form_right_side(const double* jacobian, const double* b, double* right) const;
  /// Overwrites x (n), the solution of Φ_φ x = b, from y = N⁻¹ right: Pᵀ y (columns) or Φ_φᵀ Pᵀ y
  /// (rows).
  void recover_solution(const double* jacobian, const double* y, double* x) const;

 private:
  int n_;
  NormalForm form_;
  std::vector<int> permutation_;
  std::vector<int> column_start_, row_;
  std::vector<double> values_;
  SumsOfProducts entries_;     // entries of N as products of entries of Φ_φ
  SumsOfProducts transposed_;  // P Φ_φᵀ (columns) or Φ_φᵀ Pᵀ (rows) times a vector
};

}  // namespace desmo
