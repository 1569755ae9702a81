#include "formulations/algebra/normal_equations.h"

#include <map>
#include <numeric>
#include <utility>

namespace desmo {

NormalEquations::NormalEquations(const Pattern& p, NormalForm form, std::vector<int> permutation)
    : n_(p.n), form_(form), permutation_(std::move(permutation)) {
  using Pair = SumsOfProducts::Pair;
  if (permutation_.empty()) {
    permutation_.resize(n_);
    std::iota(permutation_.begin(), permutation_.end(), 0);
  }
  std::vector<int> new_index(n_);
  for (int k = 0; k < n_; ++k) new_index[permutation_[k]] = k;

  // Entries of Φ_φ that are multiplied with each other in N: those of one row of Φ_φ
  // (NormalForm::columns), or of one column (rows). For each entry: its index in N and the position
  // of its value.
  std::vector<std::vector<std::pair<int, int>>> meeting(n_);
  std::vector<std::vector<Pair>> transposed(n_);
  for (int j = 0; j < n_; ++j)
    for (int e = p.column_start[j]; e < p.column_start[j + 1]; ++e)
      if (form_ == NormalForm::columns) {
        meeting[p.row[e]].emplace_back(new_index[j], e);
        transposed[new_index[j]].push_back({e, p.row[e]});
      } else {
        meeting[j].emplace_back(new_index[p.row[e]], e);
        transposed[j].push_back({e, new_index[p.row[e]]});
      }
  transposed_ = SumsOfProducts(transposed);

  // N_ij = Σ_r Φ_ri Φ_rj or Σ_c Φ_ic Φ_jc, i ≤ j.
  std::vector<std::map<int, std::vector<Pair>>> columns(n_);
  for (const auto& entries : meeting)
    for (const auto& [i, a] : entries)
      for (const auto& [j, b] : entries)
        if (i <= j) columns[j][i].push_back({a, b});

  std::vector<std::vector<Pair>> products;
  column_start_.push_back(0);
  for (auto& column : columns) {
    for (auto& [i, pairs] : column) {
      row_.push_back(i);
      products.push_back(std::move(pairs));
    }
    column_start_.push_back(static_cast<int>(row_.size()));
  }
  entries_ = SumsOfProducts(products);
  values_.resize(row_.size());
}

void NormalEquations::refill(const double* jacobian) {
  entries_(jacobian, jacobian, values_.data());
}

void NormalEquations::form_right_side(const double* jacobian, const double* b,
                                      double* right) const {
  if (form_ == NormalForm::columns)
    transposed_(jacobian, b, right);
  else
    for (int k = 0; k < n_; ++k) right[k] = b[permutation_[k]];
}

void NormalEquations::recover_solution(const double* jacobian, const double* y, double* x) const {
  if (form_ == NormalForm::columns)
    for (int k = 0; k < n_; ++k) x[permutation_[k]] = y[k];
  else
    transposed_(jacobian, y, x);
}

}  // namespace desmo
