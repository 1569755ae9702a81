// The change of a time: the median of the logarithms of ratios, one for each round, and its
// bootstrap interval.
#pragma once

#include <cstddef>
#include <span>

namespace desmo::report {

/// A ratio new time / old time, with the ends of its 99 % bootstrap interval.
struct Change {
  double ratio = 1, low = 1, high = 1;
  std::size_t rounds = 0;  ///< number of rounds that it is taken from
};

/// Returns exp of the median of log(time / old time) of one round or more, with its interval. There
/// are as many old times.
Change median_change(std::span<const double> times, std::span<const double> old_times);

/// Returns the probability that the median of a resample is at most the k-th smallest of n values.
/// A resample is n draws from the values, with replacement; none is made here. Its median is at
/// most that value exactly when at least half of the draws fall on the k smallest, which has a
/// binomial probability (Efron, 1979). For an even n the median is the lower of the two in the
/// middle. k: from 1 to n
double median_at_most(std::size_t k, std::size_t n);

}  // namespace desmo::report
