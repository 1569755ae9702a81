#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// A matrix by its rows: entries by column; absent entries are zero.
using SparseRows = std::vector<std::map<int, Expr>>;

/// Numbers of sample points of the current graph.
using SampleNumbers = std::vector<std::size_t>;

/// Choice of a pivot where none is large enough at every sample point.
enum class Unsound {
  has_largest_worst,  ///< the one that is largest where it is worst
  serves_most,        ///< the one large enough at the most points: at a singular one all are small
};

/// Least size of a constant pivot, over the largest entry of its column. It costs nothing to divide
/// by, and what it lets through is bounded: KLU prefers its diagonal down to the same ratio.
inline constexpr double min_constant_pivot = 1e-3;

/// A pivot of the rows that remain.
struct PivotChoice {
  int row = -1, column = -1;  ///< -1: no entry is left
  bool is_sound = false;      ///< large enough at every sample point
  double share = 0;           ///< of the sample points: where it is at least `min_constant_pivot`
};

/// Returns the best pivot at these sample points: a constant before a variable one, then the one of
/// least fill (Markowitz).
PivotChoice choose_pivot(const SparseRows& rows, const SampleNumbers& at, Unsound unsound);

/// Returns whether an entry is too small for a pivot at a sample point, compared with its column.
bool is_poor_pivot(const SparseRows& rows, int row, int column, std::size_t sample);

}  // namespace desmo::generate
