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
  constexpr double threshold = 0.1;
  std::map<int, int> column_count;
  for (const auto& r : rows)
    for (const auto& entry : r) ++column_count[entry.first];

  Candidate best, largest;
  for (int i = 0; i < static_cast<int>(rows.size()); ++i)
    for (const auto& [j, value] : rows[i]) {
      const int fill = (static_cast<int>(rows[i].size()) - 1) * (column_count[j] - 1);
      const double size = relative_size(rows, i, j);
      const Candidate c{i, j, {!value.is_constant(), fill, -size}};
      if (size >= threshold && (best.row < 0 || c.rank < best.rank)) best = c;
      const Candidate l{i, j, {false, 0, -size}};
      if (largest.row < 0 || l.rank < largest.rank) largest = l;
    }
  return best.row >= 0 ? best : largest;
}

}  // namespace

Elimination::Elimination(Rows rows, const std::vector<std::string>& names) {
  const std::size_t n = rows.size();
  while (steps_.size() < n) {
    const Candidate pivot = choose_pivot(rows);
    if (pivot.row < 0) throw std::invalid_argument("the Jacobian is structurally singular");
    std::map<int, Expr> pivot_row = std::move(rows[pivot.row]);
    rows[pivot.row].clear();
    const Expr p = pivot_row.at(pivot.column);
    pivot_row.erase(pivot.column);

    Step step{pivot.row, pivot.column, Expr(1) / p, {}, {pivot_row.begin(), pivot_row.end()}};
    PivotMonitor monitor{names[pivot.column], p, {}, {}};
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
      monitor.multipliers.push_back(multiplier);
    }
    for (const Step& earlier : steps_)
      for (const auto& [j, value] : earlier.upper)
        if (j == pivot.column) monitor.above.push_back(value);
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
