// How numbers are reduced: nothing else in the report computes with samples.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace desmo::report {

/// The repetitions of one measurement.
struct Summary {
  double median = 0;  ///< of an even count: the mean of the two in the middle
  double least = 0;
  double largest = 0;
  std::size_t count = 0;
  double half_range() const { return (largest - least) / 2; }
};

/// Of one sample or more.
Summary summarise(std::span<const double> samples);

/// How many times as fast: S = t_reference / t_variant.
struct SpeedUp {
  double value = 0;  ///< ratio of the medians
  /// Smallest reference sample over largest variant sample, and the reverse: the interval that no
  /// choice of repetitions leaves. With n repetitions each, it holds the ratio of the true medians
  /// with probability (1 - 2^(1-n))^2 at least, whatever the distribution.
  double low = 0;
  double high = 0;
  double percent = 0;   ///< improvement 100 (1 - 1/S), from the unrounded S
  bool spread = false;  ///< two repetitions or more on both sides: low and high mean something
};

SpeedUp speed_up(const Summary& reference, const Summary& variant);

/// Each member the arithmetic mean over the sizes, as in the last row of the paper's table 2; the
/// percentage too is the mean of the percentages. Of one or more.
SpeedUp mean(std::span<const SpeedUp> sizes);

/// t = c n^slope, fitted by least squares in log t over log n.
struct Slope {
  double value = 0;
  double low = 0;  ///< 95 % interval of Student's t, n - 2 degrees of freedom
  double high = 0;
  std::size_t points = 0;
};

/// One point per size (the median), so that repetitions of a size, which share its deviation from
/// the line, are not mistaken for independent evidence. Nothing with fewer than three sizes.
std::optional<Slope> fit_slope(std::span<const double> sizes, std::span<const double> seconds);

}  // namespace desmo::report
