#include "formulations/verification/condition.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "formulations/verification/reference/scaled_factors.h"

namespace desmo {

struct ConditionNumber::Matrix {
  ScaledFactors factors;
  std::vector<double> state;

  explicit Matrix(const Model& m) : factors(m), state(m.state_size()) {
    std::ranges::copy(m.fixed_values, state.begin() + m.coordinates());
  }
};

ConditionNumber::ConditionNumber(const Model& m) : matrix_(std::make_unique<Matrix>(m)) {}
ConditionNumber::~ConditionNumber() = default;

double ConditionNumber::operator()(std::span<const double> q) {
  auto& [factors, state] = *matrix_;
  std::ranges::copy(q, state.begin());
  const int n = factors.size();
  if (n == 0) return 1;
  if (!factors.factor(state)) return INFINITY;
  std::vector<double> sums(n, 0), column(n);
  for (int j = 0; j < n; ++j) {
    std::ranges::fill(column, 0.0);
    column[j] = 1;
    factors.solve(column);
    for (int i = 0; i < n; ++i) sums[i] += std::abs(column[i]);
  }
  const bool are_finite = std::ranges::all_of(sums, [](double sum) { return std::isfinite(sum); });
  return are_finite ? std::ranges::max(sums) : INFINITY;
}

}  // namespace desmo
