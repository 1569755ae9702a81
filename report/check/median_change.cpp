#include "report/check/median_change.h"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
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

// The probability of m successes or more in n draws, each with probability p, is the regularised
// incomplete beta function I_p(m, n - m + 1).
double median_at_most(std::size_t k, std::size_t n) {
  const double draws = static_cast<double>(n), half = static_cast<double>((n + 1) / 2);
  return boost::math::ibeta(half, draws - half + 1, static_cast<double>(k) / draws);
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
