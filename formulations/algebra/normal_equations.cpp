#include "formulations/algebra/normal_equations.h"

#include <map>

namespace desmo {

NormalEquations::NormalEquations(const Pattern& p, const std::vector<int>& permutation)
    : n_(p.n), permutation_(permutation), jacobian_start_(p.column_start), jacobian_row_(p.row) {
  std::vector<int> new_column(n_);
  for (int k = 0; k < n_; ++k) new_column[permutation_[k]] = k;

  // Entries of each row of Φ_φ: (new column, position of the value).
  std::vector<std::vector<std::pair<int, int>>> by_row(n_);
  for (int j = 0; j < n_; ++j)
    for (int e = p.column_start[j]; e < p.column_start[j + 1]; ++e)
      by_row[p.row[e]].emplace_back(new_column[j], e);

  // N_ij = Σ_rows Φ_ri Φ_rj, i ≤ j.
  std::vector<std::map<int, std::vector<Pair>>> columns(n_);
  for (const auto& entries : by_row)
    for (const auto& [i, a] : entries)
      for (const auto& [j, b] : entries)
        if (i <= j) columns[j][i].push_back({a, b});

  column_start_.push_back(0);
  pair_start_.push_back(0);
  for (const auto& column : columns) {
    for (const auto& [i, products] : column) {
      row_.push_back(i);
      pairs_.insert(pairs_.end(), products.begin(), products.end());
      pair_start_.push_back(static_cast<int>(pairs_.size()));
    }
    column_start_.push_back(static_cast<int>(row_.size()));
  }
  values_.resize(row_.size());
}

void NormalEquations::refill(const double* jacobian) {
  const Pair* pair = pairs_.data();
  for (std::size_t e = 0; e < values_.size(); ++e) {
    double sum = 0;
    for (const Pair* end = pairs_.data() + pair_start_[e + 1]; pair != end; ++pair)
      sum += jacobian[pair->a] * jacobian[pair->b];
    values_[e] = sum;
  }
}

void NormalEquations::transposed_product(const double* jacobian, const double* b, double* y) const {
  for (int k = 0; k < n_; ++k) {
    const int j = permutation_[k];
    double sum = 0;
    for (int e = jacobian_start_[j]; e < jacobian_start_[j + 1]; ++e)
      sum += jacobian[e] * b[jacobian_row_[e]];
    y[k] = sum;
  }
}

void NormalEquations::unpermute(const double* y, double* x) const {
  for (int k = 0; k < n_; ++k) x[permutation_[k]] = y[k];
}

}  // namespace desmo
