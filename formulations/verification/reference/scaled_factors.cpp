#include "formulations/verification/reference/scaled_factors.h"

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "formulations/algebra/klu_factors.h"
#include "formulations/model/scales.h"

namespace desmo {

struct ScaledFactors::Factors {
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::SparseMatrix<double> a;
  std::unique_ptr<KluFactors> klu;  // null: not yet made, or A is structurally singular
};

ScaledFactors::ScaledFactors(const Model& m)
    : system_(m), sums_(system_.rows()), factors_(std::make_unique<Factors>()) {
  const std::vector<double> magnitudes = nominal_magnitudes(m);
  for (const int i : system_.unknowns()) magnitude_.push_back(magnitudes[i]);
  factors_->a.resize(size(), size());
}

ScaledFactors::~ScaledFactors() = default;

bool ScaledFactors::factor(std::span<const double> state) {
  if (size() == 0) return true;  // drivers only
  auto& [entries, a, klu] = *factors_;
  std::ranges::fill(sums_, 0.0);
  entries.clear();
  system_.jacobian<double>(state, [&](int row, int i, double value) {
    const int column = system_.column(i);
    if (column < 0) return;
    value *= magnitude_[column];
    sums_[row] += std::abs(value);
    factors_->entries.emplace_back(row, column, value);
  });
  for (double& sum : sums_)
    if (!(sum > 0)) sum = 1;
  for (auto& e : entries) e = {e.row(), e.col(), e.value() / sums_[e.row()]};
  a.setFromTriplets(entries.begin(), entries.end());
  if (!klu) {
    Pattern pattern;
    pattern.n = size();
    pattern.column_start.assign(a.outerIndexPtr(), a.outerIndexPtr() + size() + 1);
    pattern.row.assign(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros());
    try {
      klu = std::make_unique<KluFactors>(pattern);
    } catch (const std::invalid_argument&) {
      return false;
    }
  }
  klu->forget_pivots();
  return klu->factor(a.valuePtr());
}

void ScaledFactors::solve(std::vector<double>& x) {
  if (!x.empty()) factors_->klu->solve(x.data());
}

void ScaledFactors::solve_unscaled(std::vector<double>& x) {
  for (std::size_t r = 0; r < x.size(); ++r) x[r] /= sums_[r];
  solve(x);
  for (std::size_t j = 0; j < x.size(); ++j) x[j] *= magnitude_[j];
}

}  // namespace desmo
