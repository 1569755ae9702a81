#include "formulations/codegen/eliminate/pivots.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace desmo::generate {

namespace {

/// As min_constant_pivot, of a pivot that is not constant.
constexpr double min_variable_pivot = 0.1;

double min_ratio(Expr pivot) {
  return pivot.is_constant() ? min_constant_pivot : min_variable_pivot;
}

/// The ratio of an entry to the largest of its column, over the sample points.
struct RelativeSize {
  double worst = 1;
  double share = 0;  ///< of the samples: where it is at least `min_constant_pivot`
  int served = 0;    ///< samples where it is at least `min_variable_pivot`
};

struct RankedChoice {
  PivotChoice pivot;
  std::tuple<bool, int, double> rank;  // smaller is better
};

/// The ratio of an entry to the largest of its column at one sample point; 0: the column vanishes.
double ratio_at(std::size_t sample, const SparseRows& rows, int row, int column) {
  const auto size = [sample](Expr e) { return std::abs(e.samples()[sample]); };
  const double pivot = size(rows[row].at(column));
  double largest = pivot;
  for (const auto& r : rows)
    if (const auto it = r.find(column); it != r.end())
      largest = std::max(largest, size(it->second));
  return largest > 0 ? pivot / largest : 0.0;
}

RelativeSize relative_size(const SparseRows& rows, int row, int column, const SampleNumbers& at) {
  RelativeSize size;
  for (const std::size_t s : at) {
    const double ratio = ratio_at(s, rows, row, column);
    size.worst = std::min(size.worst, ratio);
    size.served += ratio >= min_variable_pivot;
    size.share += (ratio >= min_constant_pivot) / static_cast<double>(at.size());
  }
  return size;
}

}  // namespace

PivotChoice choose_pivot(const SparseRows& rows, const SampleNumbers& at, Unsound unsound) {
  std::map<int, int> column_count;
  for (const auto& r : rows)
    for (const auto& entry : r) ++column_count[entry.first];

  RankedChoice best, largest;
  for (int i = 0; i < static_cast<int>(rows.size()); ++i)
    for (const auto& [j, value] : rows[i]) {
      const int fill = (static_cast<int>(rows[i].size()) - 1) * (column_count[j] - 1);
      const RelativeSize size = relative_size(rows, i, j, at);
      const RankedChoice c{{i, j, true, size.share}, {!value.is_constant(), fill, -size.worst}};
      if (size.worst >= min_ratio(value) && (best.pivot.row < 0 || c.rank < best.rank)) best = c;
      const int served = unsound == Unsound::serves_most ? size.served : 0;
      const RankedChoice l{{i, j, false, size.share}, {false, -served, -size.worst}};
      if (largest.pivot.row < 0 || l.rank < largest.rank) largest = l;
    }
  return best.pivot.row >= 0 ? best.pivot : largest.pivot;
}

bool is_poor_pivot(const SparseRows& rows, int row, int column, std::size_t sample) {
  return ratio_at(sample, rows, row, column) < min_ratio(rows[row].at(column));
}

}  // namespace desmo::generate
