#pragma once

#include <cstddef>
#include <vector>

#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// A dense linear system of two or three equations, solved by its adjugate matrix. It needs no
/// pivots, which may vanish at some orientations of a part. Callers monitor the determinant, by
/// comparing it with magnitude().
class Adjugate {
 public:
  /// Limits of the number n of equations.
  static constexpr std::size_t min_size = 2, max_size = 3;

  /// Records the inverse of an (n × n) matrix, min_size ≤ n ≤ max_size. Throws
  /// std::invalid_argument when it is structurally singular.
  explicit Adjugate(const std::vector<std::vector<Expr>>& matrix);

  /// Returns x with (matrix) x = b.
  std::vector<Expr> solve(const std::vector<Expr>& b) const;

  Expr determinant() const { return determinant_; }
  /// Returns the sum of the absolute products in the determinant: its size before cancellation.
  Expr magnitude() const { return magnitude_; }

 private:
  std::vector<std::vector<Expr>> cofactors_;
  Expr determinant_, reciprocal_, magnitude_;
};

}  // namespace desmo::generate
