#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "cases/numbers/interval.h"
#include "formulations/base/per_level.h"

namespace desmo {

/// Errors (exact minus delivered) at one level, row by row. Error i is
/// centre(i) + Σ G(i, k) t(k) + own(i) w(i) with all |t(k)|, |w(i)| ≤ 1. The numbers t(k) are
/// called symbols. The first rows are those of the state, without symbols. The rows after them are
/// lent to the groups of a long chain, to one group at a time. All lent rows share their symbols,
/// also with the tables of other levels.
struct ErrorTable {
  struct alignas(32) Row {
    double delivered = 0;
    double centre = 0, own = 0;
    double sum = 0;  ///< |centre| + Σ |G(k)| + own, a bound on the error

    /// Sets an error with own = 0. symbols: its row of G.
    void set_error(double mid, std::span<const double> symbols) {
      centre = mid, own = 0, sum = std::abs(mid);
      for (const double g : symbols) sum += std::abs(g);
      sum *= 1 + 2 * (symbols.size() + 1) * Interval::unit;
    }
  };

  std::vector<Row> rows;
  // The next three hold a number for each coordinate, which write_bounds() writes:
  std::vector<double> radius;      ///< bounds on their errors
  std::vector<double> correction;  ///< centres of their errors; 0: unknown
  std::vector<double> rest;        ///< bounds on what corrections leave of the errors
  std::vector<double> generators;  ///< G of the lent rows (lent rows × columns)
  int columns = 0;                 ///< number of symbols of the group that is certified
  int first_lent = 0;              ///< the first lent row

  /// Copies an error to a lent row, and sets its row of G to 0.
  void lend(int row, const Row& box) {
    rows[row] = box;
    std::fill_n(of_row(row), columns, 0);
  }
  /// Writes bounds on the errors of the coordinates from their rows.
  void write_bounds() {
    for (std::size_t i = 0; i < radius.size(); ++i) {
      const double sum = rows[i].sum;
      radius[i] = sum;
      correction[i] = rows[i].centre;
      rest[i] = std::fma(2 * Interval::unit, sum, sum - std::abs(correction[i]));
    }
  }
  bool has_generators(int row) const { return columns > 0 && row >= first_lent; }
  /// Return the row of G of a lent row (columns).
  double* of_row(int row) { return generators.data() + (row - first_lent) * columns; }
  const double* of_row(int row) const { return generators.data() + (row - first_lent) * columns; }
};

}  // namespace desmo
