#include "formulations/codegen/eliminate/elimination.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>

namespace desmo::generate {

namespace {

// Smallest ratio (≥) of a sound pivot to the largest entry of its column. Constant pivots may be
// smaller, since dividing by them costs nothing at run time. KLU, too, accepts a diagonal pivot of
// 1e-3 of its column.
constexpr double min_constant = 1e-3, min_variable = 0.1;

double min_ratio(Expr pivot) { return pivot.is_constant() ? min_constant : min_variable; }

/// The ratios of an entry to the largest of its column at some sample points.
struct RelativeSize {
  double worst = 1;  ///< smallest ratio
  double share = 0;  ///< fraction of the samples where the ratio is ≥ min_constant
  int served = 0;    ///< number of samples where the ratio is ≥ min_variable
};

struct PivotChoice {
  int row = -1, column = -1;
  bool is_sound = false;  // its ratio is ≥ min_ratio() at every sample
  RelativeSize size;
  std::tuple<bool, int, double> rank;  // the choice of the smallest rank is the best
};

/// Returns the ratio of an entry to the largest of its column at a sample point; 0 if all are 0.
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
    size.served += ratio >= min_variable;
    size.share += (ratio >= min_constant) / static_cast<double>(at.size());
  }
  return size;
}

PivotChoice choose_pivot(const SparseRows& rows, const SampleNumbers& at, Unsound unsound) {
  std::map<int, int> column_count;
  for (const auto& r : rows)
    for (const auto& entry : r) ++column_count[entry.first];

  PivotChoice best, largest;
  for (int i = 0; i < static_cast<int>(rows.size()); ++i)
    for (const auto& [j, value] : rows[i]) {
      const int fill = (static_cast<int>(rows[i].size()) - 1) * (column_count[j] - 1);
      const RelativeSize size = relative_size(rows, i, j, at);
      const PivotChoice c{i, j, true, size, {!value.is_constant(), fill, -size.worst}};
      if (size.worst >= min_ratio(value) && (best.row < 0 || c.rank < best.rank)) best = c;
      const int served = unsound == Unsound::serves_most ? size.served : 0;
      const PivotChoice l{i, j, false, size, {false, -served, -size.worst}};
      if (largest.row < 0 || l.rank < largest.rank) largest = l;
    }
  return best.row >= 0 ? best : largest;
}

/// Returns the largest |a| / |b| at these samples, ignoring those where it is not finite. There the
/// order of pivots fails, and monitors shall refuse it.
double max_ratio(Expr a, Expr b, const SampleNumbers& at) {
  const auto& x = Graph::current().samples(a.id());
  const auto& y = Graph::current().samples(b.id());
  double largest = 0;
  for (const std::size_t s : at)
    if (const double ratio = std::abs(x[s] / y[s]); std::isfinite(ratio))
      largest = std::max(largest, ratio);
  return largest;
}

/// Smallest RelativeSize::share of a pivot (≥). With a smaller one, parts of the type point in
/// different directions, and an adjugate takes over. Else monitors refuse it where it is too small.
constexpr double min_share = 0.9;

/// An elimination before the first unsound pivot that an adjugate of the remaining rows can avoid.
struct Mark {
  SparseRows rows;
  Elimination elimination;
};

std::vector<int> columns_of(const SparseRows& rows) {
  std::set<int> columns;
  for (const auto& r : rows)
    for (const auto& entry : r) columns.insert(entry.first);
  return {columns.begin(), columns.end()};
}

/// Approximate factors by which a ratio may exceed 1 + its largest sample before it is refused.
constexpr double magnification_allowed = 1e3, cancellation_allowed = 1e6;

/// Returns the power of two at or below allowed (1 + largest), a bound far from all samples. So the
/// text of the code does not change with every digit of the samples.
double bound(double allowed, double largest) {
  return std::exp2(std::floor(std::log2(allowed * (1 + largest))));
}

SampleNumbers all_samples() {
  SampleNumbers all(Graph::current().sample_count());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace

Elimination::Elimination(SparseRows rows)
    : Elimination(std::move(rows), all_samples(), Unsound::has_largest_worst) {}

Elimination::Elimination(SparseRows rows, SampleNumbers at, Unsound unsound) : at_(std::move(at)) {
  const std::size_t n = rows.size();
  is_poor_.resize(Graph::current().sample_count());
  std::optional<Mark> mark;
  while (steps_.size() < n) {
    const PivotChoice pivot = choose_pivot(rows, at_, unsound);
    if (pivot.row < 0) throw std::invalid_argument("the Jacobian is structurally singular");
    const std::size_t open = n - steps_.size();
    if (!pivot.is_sound && !mark && open >= Adjugate::min_size && open <= Adjugate::max_size)
      mark.emplace(Mark{rows, *this});
    if (mark && pivot.size.share < min_share) {
      *this = std::move(mark->elimination);
      solve_last_by_adjugate(mark->rows);
      break;
    }
    const double least = min_ratio(rows[pivot.row].at(pivot.column));
    for (std::size_t s = 0; s < is_poor_.size(); ++s)
      is_poor_[s] = is_poor_[s] || ratio_at(s, rows, pivot.row, pivot.column) < least;
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
            {multiplier, bound(magnification_allowed, max_ratio(multiplier, Expr(1), at_))});
    }
    for (const Step& earlier : steps_)
      for (const auto& [j, value] : earlier.upper)
        if (j == pivot.column)
          monitor.against.push_back(
              {value, 1 / bound(cancellation_allowed, max_ratio(value, p, at_))});
    if (!p.is_constant()) monitors_.push_back(std::move(monitor));
    steps_.push_back(std::move(step));
  }
}

void Elimination::solve_last_by_adjugate(const SparseRows& rows) {
  std::vector<int> open, columns = columns_of(rows);
  for (int i = 0; i < static_cast<int>(rows.size()); ++i)
    if (!rows[i].empty()) open.push_back(i);
  if (open.size() != columns.size() || open.size() + steps_.size() != rows.size())
    throw std::invalid_argument("the Jacobian is structurally singular");
  std::vector<std::vector<Expr>> matrix;
  for (const int i : open) {
    matrix.emplace_back();
    for (const int j : columns) {
      const auto entry = rows[i].find(j);
      matrix.back().push_back(entry == rows[i].end() ? Expr(0) : entry->second);
    }
  }
  last_.emplace(Last{std::move(open), std::move(columns), Adjugate(matrix)});

  const std::vector<double>& determinant = last_->inverse.determinant().samples();
  const std::vector<double>& magnitude = last_->inverse.magnitude().samples();
  for (std::size_t s = 0; s < is_poor_.size(); ++s)
    is_poor_[s] = is_poor_[s] || !(std::abs(determinant[s]) >= min_constant * magnitude[s]);

  const auto add_monitors = [&](Expr what, Expr against) {
    monitors_.push_back(
        {what, {}, {{against, 1 / bound(cancellation_allowed, max_ratio(against, what, at_))}}});
  };
  add_monitors(last_->inverse.determinant(), last_->inverse.magnitude());
  // Compares what is left of a column with its entries in earlier pivot rows.
  for (std::size_t k = 0; k < last_->columns.size(); ++k) {
    Expr size = 0, before = 0;
    for (const std::vector<Expr>& row : matrix) size = size + abs(row[k]);
    for (const Step& earlier : steps_)
      for (const auto& [j, value] : earlier.upper)
        if (j == last_->columns[k]) before = before + abs(value);
    if (!before.is_zero()) add_monitors(size, before);
  }
}

std::vector<Elimination> eliminations(const SparseRows& matrix, std::size_t max_count,
                                      std::size_t first) {
  SampleNumbers open = all_samples();
  std::vector<Elimination> result;
  SampleNumbers at(open.begin(), open.begin() + static_cast<std::ptrdiff_t>(first));
  while (!open.empty() && result.size() < max_count) {
    Elimination next(matrix, std::move(at),
                     result.empty() ? Unsound::has_largest_worst : Unsound::serves_most);
    const bool serves = std::erase_if(open, [&](std::size_t s) { return !next.is_poor_at(s); }) > 0;
    if (!serves && !result.empty()) break;
    result.push_back(std::move(next));
    at = open;
  }
  return result;
}

std::vector<Expr> Elimination::solve(std::vector<Expr> b) const {
  for (const Step& s : steps_)
    for (const auto& [i, multiplier] : s.lower) b[i] = b[i] - multiplier * b[s.row];
  std::vector<Expr> x(b.size());
  if (last_) {
    std::vector<Expr> right;
    for (const int i : last_->rows) right.push_back(b[i]);
    const std::vector<Expr> left = last_->inverse.solve(right);
    for (std::size_t k = 0; k < left.size(); ++k) x[last_->columns[k]] = left[k];
  }
  for (auto s = steps_.rbegin(); s != steps_.rend(); ++s) {
    Expr sum = b[s->row];
    for (const auto& [j, value] : s->upper) sum = sum - value * x[j];
    x[s->column] = sum * s->reciprocal;
  }
  return x;
}

}  // namespace desmo::generate
