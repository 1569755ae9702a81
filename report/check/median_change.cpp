#include "report/check/median_change.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "report/statistics/statistics.h"

namespace desmo::report {
namespace {

constexpr double tail = 0.005;  // probability on either side of the 99 % interval

/// Returns the p-quantile of the median of a resample: the smallest of the values that this median
/// does not exceed with a probability of at least p. values: in ascending order.
double quantile(const std::vector<double>& values, double p) {
  std::size_t k = 1;
  while (k < values.size() && median_at_most(k, values.size()) < p) ++k;
  return values[k - 1];
}

}  // namespace

double median_at_most(std::size_t k, std::size_t n) {
  if (k >= n) return 1;
  const double p = static_cast<double>(k) / static_cast<double>(n);
  double sum = 0;
  for (std::size_t j = (n + 1) / 2; j <= n; ++j)
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(j + 1.0) - std::lgamma(n - j + 1.0) +
                    static_cast<double>(j) * std::log(p) +
                    static_cast<double>(n - j) * std::log1p(-p));
  return sum;
}

Change median_change(std::span<const double> times, std::span<const double> old_times) {
  std::vector<double> logarithms;
  for (std::size_t i = 0; i < times.size(); ++i)
    logarithms.push_back(std::log(times[i] / old_times[i]));
  std::ranges::sort(logarithms);
  return {std::exp(summarise(logarithms).median), std::exp(quantile(logarithms, tail)),
          std::exp(quantile(logarithms, 1 - tail)), logarithms.size()};
}

}  // namespace desmo::report
