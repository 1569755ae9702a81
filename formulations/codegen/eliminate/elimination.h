#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "formulations/codegen/eliminate/adjugate.h"
#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// Conditions under which a recorded pivot is trusted at run time: it must not be far smaller
/// beside the entries of its column than it was at the worst of the sample points.
struct PivotMonitor {
  struct Bound {
    Expr value;
    double bound;
  };
  Expr pivot;
  std::vector<Bound> magnified;  ///< |value| < bound: a row below, divided by the pivot
  std::vector<Bound> against;    ///< |pivot| > bound · |value|: a row eliminated before
};

/// Sparse Gaussian elimination of Φ_φ, recorded once in a pivot order that is fixed here.
///
/// Pivots: constants first, then least fill (Markowitz), among those that at every sample point
/// are not too small beside the largest entry of their column. Where the last two or three rows
/// have none that serves most samples, since parts of one type point different ways, these rows are
/// solved by their adjugate.
class Elimination {
 public:
  /// matrix[i][j]: entries of row i by column; absent ones are structurally zero.
  /// Throws std::invalid_argument when it is structurally singular.
  explicit Elimination(std::vector<std::map<int, Expr>> matrix);

  /// x with Φ_φ x = b.
  std::vector<Expr> solve(std::vector<Expr> b) const;

  /// One for each pivot that is not a constant; of rows solved by their adjugate, one for the
  /// determinant and one for each column that earlier rows have entries in.
  const std::vector<PivotMonitor>& monitors() const { return monitors_; }

 private:
  struct Step {
    int row, column;
    Expr reciprocal;                          // of the pivot
    std::vector<std::pair<int, Expr>> lower;  // (row, multiplier)
    std::vector<std::pair<int, Expr>> upper;  // (column, entry) of the pivot's row
  };
  /// The rows and columns that are left when no pivot will do.
  struct Last {
    std::vector<int> rows, columns;
    Adjugate inverse;
  };
  void solve_last_by_adjugate(const std::vector<std::map<int, Expr>>& rows);

  std::vector<Step> steps_;
  std::optional<Last> last_;
  std::vector<PivotMonitor> monitors_;
};

}  // namespace desmo::generate
