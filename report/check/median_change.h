// The change of a time: the median over rounds of the logarithm of a ratio, and its bootstrap
// interval.
#pragma once

#include <cstddef>
#include <span>

namespace desmo::report {

/// A ratio of times, new over old, with the ends of its 99 % bootstrap interval.
struct Change {
  double ratio = 1, low = 1, high = 1;
  std::size_t rounds = 0;
};

/// Returns exp of the median of log(time / old time) over one round or more, with its interval.
Change median_change(std::span<const double> times, std::span<const double> old_times);

/// Returns the probability that the median of a resample of n values, drawn with replacement, is at
/// most the k-th smallest of them. No resample is drawn: that is so exactly when a majority of its
/// n draws fall on the first k, which has a binomial probability (Efron, 1979). With an even n the
/// lower of the two in the middle is taken.
double median_at_most(std::size_t k, std::size_t n);

}  // namespace desmo::report
