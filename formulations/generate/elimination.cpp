#include "formulations/generate/elimination.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace desmo::generate {

namespace {

using Rows = std::vector<std::map<int, Expr>>;

struct Candidate {
  int row = -1, column = -1;
  std::tuple<bool, int, double> rank;  // smaller is better
};

/// The smallest ratio, over the sample points, of an entry to the largest of its column.
double relative_size(const Rows& rows, int row, int column) {
  const std::vector<double>& pivot = Graph::current().samples(rows[row].at(column).id());
  double worst = 1;
  for (std::size_t s = 0; s < pivot.size(); ++s) {
    double largest = std::abs(pivot[s]);
    for (const auto& r : rows)
      if (const auto it = r.find(column); it != r.end())
        largest = std::max(largest, std::abs(Graph::current().samples(it->second.id())[s]));
    worst = std::min(worst, largest > 0 ? std::abs(pivot[s]) / largest : 0.0);
  }
  return worst;
}

Candidate choose_pivot(const Rows& rows) {
  // Beside the largest of the column. A constant costs nothing to divide by, and what it lets
  // through is bounded: KLU prefers its diagonal down to the same ratio.
  constexpr double least_constant = 1e-3, least_variable = 0.1;
  std::map<int, int> column_count;
  for (const auto& r : rows)
    for (const auto& entry : r) ++column_count[entry.first];

  Candidate best, largest;
  for (int i = 0; i < static_cast<int>(rows.size()); ++i)
    for (const auto& [j, value] : rows[i]) {
      const int fill = (static_cast<int>(rows[i].size()) - 1) * (column_count[j] - 1);
      const double size = relative_size(rows, i, j);
      const Candidate c{i, j, {!value.is_constant(), fill, -size}};
      if (size >= (value.is_constant() ? least_constant : least_variable) &&
          (best.row < 0 || c.rank < best.rank))
        best = c;
      const Candidate l{i, j, {false, 0, -size}};
      if (largest.row < 0 || l.rank < largest.rank) largest = l;
    }
  return best.row >= 0 ? best : largest;
}

/// The largest |a| / |b| over the sample points, except where it is not finite: where the order of
/// the pivots fails, the monitors shall refuse it.
double largest_ratio(Expr a, Expr b) {
  const auto& x = Graph::current().samples(a.id());
  const auto& y = Graph::current().samples(b.id());
  double largest = 0;
  for (std::size_t s = 0; s < x.size(); ++s)
    if (const double ratio = std::abs(x[s] / y[s]); std::isfinite(ratio))
      largest = std::max(largest, ratio);
  return largest;
}

/// How much worse than the worst sample a pivot may become before it is distrusted.
constexpr double magnification_allowed = 1e3, cancellation_allowed = 1e6;

/// A bound that ratios of that size are far from, the power of two below it: the text of the code
/// does not change with every digit of the samples.
double bound(double allowed, double largest) {
  return std::exp2(std::floor(std::log2(allowed * (1 + largest))));
}

}  // namespace

Elimination::Elimination(Rows rows) {
  const std::size_t n = rows.size();
  while (steps_.size() < n) {
    const Candidate pivot = choose_pivot(rows);
    if (pivot.row < 0) throw std::invalid_argument("the Jacobian is structurally singular");
    std::map<int, Expr> pivot_row = std::move(rows[pivot.row]);
    rows[pivot.row].clear();
    const Expr p = pivot_row.at(pivot.column);
    pivot_row.erase(pivot.column);

    Step step{pivot.row, pivot.column, Expr(1) / p, {}, {pivot_row.begin(), pivot_row.end()}};
    PivotMonitor monitor{p, {}, {}};
    for (int i = 0; i < static_cast<int>(n); ++i) {
      const auto it = rows[i].find(pivot.column);
      if (it == rows[i].end()) continue;
      const Expr multiplier = it->second * step.reciprocal;
      rows[i].erase(it);
      for (const auto& [j, upper] : pivot_row) {
        const Expr updated = rows[i][j] - multiplier * upper;
        if (updated.is_zero())
          rows[i].erase(j);
        else
          rows[i][j] = updated;
      }
      step.lower.emplace_back(i, multiplier);
      if (!multiplier.is_constant())
        monitor.magnified.push_back(
            {multiplier, bound(magnification_allowed, largest_ratio(multiplier, Expr(1)))});
    }
    for (const Step& earlier : steps_)
      for (const auto& [j, value] : earlier.upper)
        if (j == pivot.column)
          monitor.against.push_back(
              {value, 1 / bound(cancellation_allowed, largest_ratio(value, p))});
    if (!p.is_constant()) monitors_.push_back(std::move(monitor));
    steps_.push_back(std::move(step));
  }
}

std::vector<Expr> Elimination::solve(std::vector<Expr> b) const {
  for (const Step& s : steps_)
    for (const auto& [i, multiplier] : s.lower) b[i] = b[i] - multiplier * b[s.row];
  std::vector<Expr> x(b.size());
  for (auto s = steps_.rbegin(); s != steps_.rend(); ++s) {
    Expr sum = b[s->row];
    for (const auto& [j, value] : s->upper) sum = sum - value * x[j];
    x[s->column] = sum * s->reciprocal;
  }
  return x;
}

}  // namespace desmo::generate
