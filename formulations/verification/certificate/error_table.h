#pragma once

#include <algorithm>
#include <vector>

#include "formulations/base/per_level.h"

namespace desmo {

/// Errors (exact minus delivered) at one level, row by row. Error i is
/// center(i) + Σ G(i, k) t(k) + own(i) w(i) with all |t(k)|, |w(i)| ≤ 1. The first rows are those
/// of the state, without symbols t: fixed entities have errors of zero. Rows after them are lent to
/// one structural group of a long chain after the other; they share the symbols t, and so do
/// levels.
struct ErrorTable {
  std::vector<double> center, own;
  std::vector<double> sum;         ///< |center(i)| + Σ |G(i, k)| + own(i), rounded up
  std::vector<double> generators;  ///< G of the lent rows
  int columns = 0, first_lent = 0;

  void resize(int state_size, int lent_rows, int max_generators) {
    first_lent = state_size;
    for (auto* values : {&center, &own, &sum}) values->resize(state_size + lent_rows);
    generators.resize(max_generators);
  }
  void set(int row, double c, double o, double s) { center[row] = c, own[row] = o, sum[row] = s; }
  bool has_generators(int row) const { return columns > 0 && row >= first_lent; }
  double* of_row(int row) { return generators.data() + (row - first_lent) * columns; }
  const double* of_row(int row) const { return generators.data() + (row - first_lent) * columns; }
};

}  // namespace desmo
