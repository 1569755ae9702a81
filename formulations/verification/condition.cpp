#include "formulations/verification/condition.h"

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "formulations/algebra/klu_factors.h"
#include "formulations/model/scales.h"
#include "formulations/verification/reference/whole_system.h"

namespace desmo {

struct ConditionNumber::Matrices {
  const Model& m;
  WholeSystem system;
  std::vector<double> magnitude, state;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::SparseMatrix<double> a;
  std::unique_ptr<KluFactors> factors;  // null: structurally singular, or not yet made

  explicit Matrices(const Model& model)
      : m(model),
        system(m),
        magnitude(nominal_magnitudes(m)),
        state(m.state_size()),
        a(system.rows(), static_cast<int>(system.unknowns().size())) {
    std::ranges::copy(m.fixed_values, state.begin() + m.coordinates());
  }

  /// a = R⁻¹ Φ_φ S
  void assemble(std::span<const double> q) {
    std::ranges::copy(q, state.begin());
    std::vector<double> sums(system.rows(), 0);
    entries.clear();
    system.jacobian<double>(state, [&](int row, int i, double value) {
      const int column = system.column(i);
      if (column < 0) return;
      entries.emplace_back(row, column, value * magnitude[i]);
      sums[row] += std::abs(value * magnitude[i]);
    });
    for (auto& e : entries)
      if (sums[e.row()] > 0) e = {e.row(), e.col(), e.value() / sums[e.row()]};
    a.setFromTriplets(entries.begin(), entries.end());
  }
};

ConditionNumber::ConditionNumber(const Model& m) : matrices_(std::make_unique<Matrices>(m)) {}
ConditionNumber::~ConditionNumber() = default;

double ConditionNumber::operator()(std::span<const double> q) {
  matrices_->assemble(q);
  const Eigen::SparseMatrix<double>& a = matrices_->a;
  const int n = static_cast<int>(a.rows());
  if (n == 0) return 1;
  auto& factors = matrices_->factors;
  if (!factors) {
    Pattern pattern;
    pattern.n = n;
    pattern.column_start.assign(a.outerIndexPtr(), a.outerIndexPtr() + n + 1);
    pattern.row.assign(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros());
    try {
      factors = std::make_unique<KluFactors>(pattern);
    } catch (const std::invalid_argument&) {
      return INFINITY;
    }
  }
  if (!factors->factor(a.valuePtr())) return INFINITY;
  std::vector<double> sums(n, 0), column(n);
  for (int j = 0; j < n; ++j) {
    std::ranges::fill(column, 0.0);
    column[j] = 1;
    factors->solve(column.data());
    for (int i = 0; i < n; ++i) sums[i] += std::abs(column[i]);
  }
  double norm = 0;
  for (const double sum : sums)
    if (!(sum <= norm)) norm = sum;  // NaN stays
  return std::isfinite(norm) ? norm : INFINITY;
}

}  // namespace desmo
