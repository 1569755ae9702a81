#pragma once

#include <map>
#include <vector>

#include "formulations/generate/expression.h"

namespace desmo::generate {

/// A condition under which the elimination is trusted at run time.
struct PivotMonitor {
  std::string name;              ///< of the unknown whose column it is
  Expr pivot;
  std::vector<Expr> multipliers; ///< rows below, divided by the pivot
  std::vector<Expr> above;       ///< entries of the column in rows eliminated before
};

/// Sparse Gaussian elimination of Φ_φ, recorded once in a pivot order that is fixed here.
///
/// Pivots: constants first, then least fill (Markowitz), among those that at every sample point
/// are at least a tenth of the largest entry of their column.
class Elimination {
 public:
  /// matrix[i][j]: entries of row i by column; absent ones are structurally zero.
  Elimination(std::vector<std::map<int, Expr>> matrix, const std::vector<std::string>& names);

  /// x with Φ_φ x = b.
  std::vector<Expr> solve(std::vector<Expr> b) const;

  /// One for each pivot that is not a constant.
  const std::vector<PivotMonitor>& monitors() const { return monitors_; }

 private:
  struct Step {
    int row, column;
    Expr reciprocal;                              // of the pivot
    std::vector<std::pair<int, Expr>> lower;      // (row, multiplier)
    std::vector<std::pair<int, Expr>> upper;      // (column, entry) of the pivot's row
  };
  std::vector<Step> steps_;
  std::vector<PivotMonitor> monitors_;
};

}  // namespace desmo::generate
