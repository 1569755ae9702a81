// The change of a time: the median over rounds of the logarithm of a ratio, and its bootstrap
// interval.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace desmo::report {

/// A ratio of times, new over old, with the ends of its 99 % bootstrap interval.
struct Change {
  double ratio = 1, low = 1, high = 1;
  std::size_t rounds = 0;
};

/// log(numerator / denominator), round by round, for as many rounds as both have.
std::vector<double> log_ratios(std::span<const double> numerators,
                               std::span<const double> denominators);

/// The values that a median takes in resamples drawn with replacement, ascending, with the
/// probability of each. No resample is drawn: of n values in ascending order, the median of a
/// resample is at most the k-th exactly when a majority of its n draws fall on the first k, which
/// has a binomial probability (Efron, 1979). With an even n the lower of the two in the middle is
/// taken.
struct MedianDistribution {
  std::vector<double> value, probability;
};
MedianDistribution bootstrap_median(std::span<const double> values);

/// Returns exp of the median of one or more logarithms, with its interval.
Change median_change(std::span<const double> logarithms);

}  // namespace desmo::report
