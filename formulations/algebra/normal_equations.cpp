#include "formulations/algebra/normal_equations.h"

#include <map>
#include <utility>

namespace desmo {

NormalEquations::NormalEquations(const Pattern& p, NormalForm form,
                                 const std::vector<int>& permutation)
    : n_(p.n),
      form_(form),
      permutation_(permutation),
      jacobian_start_(p.column_start),
      jacobian_row_(p.row) {
  std::vector<int> new_index(n_);
  for (int k = 0; k < n_; ++k) new_index[permutation_[k]] = k;

  // Entries that meet in products, being of one row (columns) or one column (rows) of Φ_φ:
  // (index in N, position of the value).
  std::vector<std::vector<std::pair<int, int>>> meeting(n_);
  for (int j = 0; j < n_; ++j)
    for (int e = p.column_start[j]; e < p.column_start[j + 1]; ++e)
      if (form_ == NormalForm::columns) {
        meeting[p.row[e]].emplace_back(new_index[j], e);
      } else {
        jacobian_row_[e] = new_index[p.row[e]];
        meeting[j].emplace_back(jacobian_row_[e], e);
      }

  // N_ij = Σ_r Φ_ri Φ_rj or Σ_c Φ_ic Φ_jc, i ≤ j.
  std::vector<std::map<int, std::vector<Pair>>> columns(n_);
  for (const auto& entries : meeting)
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

void NormalEquations::right_side(const double* jacobian, const double* b, double* right) const {
  if (form_ == NormalForm::columns)
    for (int k = 0; k < n_; ++k) right[k] = column_product(permutation_[k], jacobian, b);
  else
    for (int k = 0; k < n_; ++k) right[k] = b[permutation_[k]];
}

void NormalEquations::solution(const double* jacobian, const double* y, double* x) const {
  if (form_ == NormalForm::columns)
    for (int k = 0; k < n_; ++k) x[permutation_[k]] = y[k];
  else
    for (int j = 0; j < n_; ++j) x[j] = column_product(j, jacobian, y);
}

}  // namespace desmo
