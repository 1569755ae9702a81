#pragma once

#include <map>
#include <optional>
#include <vector>

#include "formulations/codegen/eliminate/elimination.h"
#include "formulations/codegen/order/closed_form.h"

namespace desmo::generate {

/// The linear system of a core (see OrderSection), recorded once. A core of two unknowns is solved
/// by Cramer's rule, whose latency is short; any other by elimination.
class CoreSystem {
 public:
  /// Records the factorisation. matrix[i]: row i, entries by column; absent entries are zero.
  /// Throws std::invalid_argument when the matrix is structurally singular.
  explicit CoreSystem(std::vector<std::map<int, Expr>> matrix);

  /// Returns x with (matrix) x = b.
  std::vector<Expr> solve(const std::vector<Expr>& b) const;

  /// Return the conditions under which a solution is trusted.
  std::vector<PivotMonitor> pivots() const;
  const std::vector<SizeMonitor>& sizes() const { return sizes_; }

 private:
  std::optional<Elimination> elimination_;  // none: by Cramer's rule
  Expr a_, b_, c_, d_;                      // the matrix (a b; c d)
  Expr inverse_;                            // 1/determinant
  std::vector<SizeMonitor> sizes_;
};

}  // namespace desmo::generate
