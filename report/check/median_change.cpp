#include "report/check/median_change.h"

#include <algorithm>
#include <cmath>

#include "report/statistics/statistics.h"

namespace desmo::report {
namespace {

constexpr double tail = 0.005;  // on either side of the 99 % interval

/// P(at least `least` of n draws), each with probability p.
double binomial_tail(std::size_t n, std::size_t least, double p) {
  if (p >= 1) return 1;
  double sum = 0;
  for (std::size_t j = least; j <= n; ++j)
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(j + 1.0) - std::lgamma(n - j + 1.0) +
                    static_cast<double>(j) * std::log(p) +
                    static_cast<double>(n - j) * std::log1p(-p));
  return sum;
}

/// Returns the smallest value that the median exceeds with a probability of at most 1 − p.
double quantile(const MedianDistribution& d, double p) {
  double up_to = 0;
  for (std::size_t k = 0; k < d.value.size(); ++k)
    if ((up_to += d.probability[k]) >= p) return d.value[k];
  return d.value.back();
}

}  // namespace

std::vector<double> log_ratios(std::span<const double> numerators,
                               std::span<const double> denominators) {
  std::vector<double> result;
  for (std::size_t i = 0; i < std::min(numerators.size(), denominators.size()); ++i)
    result.push_back(std::log(numerators[i] / denominators[i]));
  return result;
}

MedianDistribution bootstrap_median(std::span<const double> values) {
  MedianDistribution d{{values.begin(), values.end()}, {}};
  std::ranges::sort(d.value);
  const std::size_t n = values.size(), majority = (n + 1) / 2;
  double below = 0;
  for (std::size_t k = 1; k <= n; ++k) {
    const double up_to =
        binomial_tail(n, majority, static_cast<double>(k) / static_cast<double>(n));
    d.probability.push_back(up_to - below);
    below = up_to;
  }
  return d;
}

Change median_change(std::span<const double> logarithms) {
  const MedianDistribution d = bootstrap_median(logarithms);
  return {std::exp(summarise(logarithms).median), std::exp(quantile(d, tail)),
          std::exp(quantile(d, 1 - tail)), logarithms.size()};
}

}  // namespace desmo::report
