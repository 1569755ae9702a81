#pragma once

#include <map>
#include <optional>
#include <vector>

#include "formulations/codegen/eliminate/elimination.h"
#include "formulations/codegen/order/closed_form.h"

namespace desmo::generate {

/// The linear systems of a core, recorded once: two unknowns by Cramer's rule, with one division
/// and soon done; others by elimination.
class CoreSystem {
 public:
  /// matrix[i][j]: entries of row i by column; absent ones are structurally zero. Throws
  /// std::invalid_argument when it is structurally singular.
  explicit CoreSystem(std::vector<std::map<int, Expr>> matrix);

  /// x with (matrix) x = b.
  std::vector<Expr> solve(const std::vector<Expr>& b) const;

  /// What has to hold for a solution to be trusted.
  std::vector<PivotMonitor> pivots() const;
  const std::vector<SizeMonitor>& sizes() const { return sizes_; }

 private:
  std::optional<Elimination> elimination_;  // none: by Cramer's rule
  Expr a_, b_, c_, d_;                      // the matrix (a b; c d)
  Expr inverse_;                            // of its determinant
  std::vector<SizeMonitor> sizes_;
};

}  // namespace desmo::generate
