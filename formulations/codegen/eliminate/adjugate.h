#pragma once

#include <vector>

#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// A dense system of two or three equations, solved by its adjugate. It has no pivot that is small
/// where a part points another way; all that has to be watched is the determinant.
class Adjugate {
 public:
  static constexpr std::size_t least = 2, most = 3;

  /// matrix: (n × n), n from `least` to `most`. Throws std::invalid_argument when it is
  /// structurally singular.
  explicit Adjugate(const std::vector<std::vector<Expr>>& matrix);

  /// Returns x with (matrix) x = b.
  std::vector<Expr> solve(const std::vector<Expr>& b) const;

  Expr determinant() const { return determinant_; }
  /// Returns the determinant's products, each by its size: what cancels in it.
  Expr magnitude() const { return magnitude_; }

 private:
  std::vector<std::vector<Expr>> cofactors_;
  Expr determinant_, reciprocal_, magnitude_;
};

}  // namespace desmo::generate
