#include "report/check/median_change.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

using Weighted = std::vector<std::pair<double, double>>;  // value, probability

/// The 0.5 % and 99.5 % quantiles.
std::pair<double, double> interval(Weighted values) {
  std::ranges::sort(values);
  double below = 0;
  auto low = values.front().first, high = values.back().first;
  for (const auto& [value, probability] : values) {
    const double up_to = below + probability;
    if (below < tail && up_to >= tail) low = value;
    if (below < 1 - tail && up_to >= 1 - tail) {
      high = value;
      break;
    }
    below = up_to;
  }
  return {low, high};
}

Change change(double middle, Weighted distribution, std::size_t rounds) {
  const auto [low, high] = interval(std::move(distribution));
  return {std::exp(middle), std::exp(low), std::exp(high), rounds};
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
  Weighted weighted;
  for (std::size_t i = 0; i < d.value.size(); ++i)
    weighted.emplace_back(d.value[i], d.probability[i]);
  return change(summarise(logarithms).median, std::move(weighted), logarithms.size());
}

Change median_change(std::span<const double> now, std::span<const double> then) {
  const MedianDistribution a = bootstrap_median(now), b = bootstrap_median(then);
  Weighted weighted;
  for (std::size_t i = 0; i < a.value.size(); ++i)
    for (std::size_t j = 0; j < b.value.size(); ++j)
      weighted.emplace_back(a.value[i] - b.value[j], a.probability[i] * b.probability[j]);
  return change(summarise(now).median - summarise(then).median, std::move(weighted),
                std::min(now.size(), then.size()));
}

}  // namespace desmo::report
