#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "formulations/codegen/eliminate/adjugate.h"
#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// A matrix by its rows: entries by column; absent entries are zero.
using SparseRows = std::vector<std::map<int, Expr>>;

/// The conditions under which a recorded pivot is trusted at run time. Compared with its column, it
/// must not be far smaller than at the worst sample point.
struct PivotMonitor {
  struct Bound {
    Expr value;
    double bound;
  };
  Expr pivot;
  std::vector<Bound> magnified;  ///< |value| < bound; value: multiplier of a remaining row
  std::vector<Bound> against;    ///< |pivot| > bound · |value|; value: entry of its column that is
                                 ///< in an earlier pivot row
};

/// Numbers of sample points of the current graph.
using SampleNumbers = std::vector<std::size_t>;

/// Choice of a pivot where none is large enough, compared with its column, at every sample point.
enum class Unsound {
  has_largest_worst,  ///< the one whose smallest relative size is largest
  serves_most,        ///< the one that is large enough at the most sample points
};

/// A sparse Gaussian elimination of Φ_φ (Jacobian by the part's unknowns), recorded once with a
/// fixed pivot order.
///
/// Constant pivots come first, then pivots of least fill (Markowitz). A pivot is sound when it is
/// large enough, compared with its column, at every given sample point. Where there is none,
/// `Unsound` tells which is taken. The last two or three rows are solved by their adjugate if a
/// pivot there is far too small at more than a tenth of the samples: parts of one type may be
/// oriented differently.
class Elimination {
 public:
  /// Records the elimination. Throws std::invalid_argument when the matrix is structurally
  /// singular.
  explicit Elimination(SparseRows matrix);
  /// Records it with pivots chosen at these sample points alone.
  Elimination(SparseRows matrix, SampleNumbers at, Unsound unsound);

  /// Returns whether a pivot is too small at a sample point, compared with its column. The
  /// determinant of rows solved by their adjugate is compared with its products.
  bool is_poor_at(std::size_t sample) const { return is_poor_[sample]; }

  /// Returns x with Φ_φ x = b.
  std::vector<Expr> solve(std::vector<Expr> b) const;

  /// Returns a monitor for each pivot that is not constant. Rows solved by their adjugate have one
  /// for the determinant. They have another for each column that occurs in earlier pivot rows.
  const std::vector<PivotMonitor>& monitors() const { return monitors_; }

 private:
  struct Step {
    int row, column;
    Expr reciprocal;                          // 1/pivot
    std::vector<std::pair<int, Expr>> lower;  // remaining rows, each with its multiplier
    std::vector<std::pair<int, Expr>> upper;  // columns of the pivot's row, each with its entry
  };
  /// The remaining rows and columns, solved by their adjugate.
  struct Last {
    std::vector<int> rows, columns;
    Adjugate inverse;
  };
  void solve_last_by_adjugate(const SparseRows& rows);

  SampleNumbers at_;
  std::vector<bool> is_poor_;  // is_poor_at() of each sample point
  std::vector<Step> steps_;
  std::optional<Last> last_;
  std::vector<PivotMonitor> monitors_;
};

/// Returns eliminations of one matrix. At each sample point one of them has no poor pivots.
/// Exceptions are points near singular positions, and points that `max_count` eliminations do not
/// serve.
/// - max_count: largest number of eliminations
/// - first: number of points, from the beginning, at which the first elimination is chosen. Each
///   later one is chosen at all points where those before it are poor.
std::vector<Elimination> eliminations(const SparseRows& matrix, std::size_t max_count,
                                      std::size_t first);

}  // namespace desmo::generate
