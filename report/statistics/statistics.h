// Reduction of samples to numbers: nothing else in the report computes with samples.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "report/read/timed.h"

namespace desmo::report {

/// Returns the seconds that an analysis takes when nothing disturbs it.
///
/// Each window of each analysis gives a point: updates of unknowns per instant, and seconds per
/// instant. Undisturbed points lie on a rising line, since every update costs the same. A
/// disturbance only adds time, so disturbed points lie above that line. The result is read off the
/// lower convex envelope of all points, at the updates per instant of the whole motion. A single
/// point may bound it further: more updates never take less time, nor more than in proportion.
///
/// - windows: with samples of one analysis or more; of two or more when one is left out
/// - left_out: index of the analysis that is not used
double undisturbed(const Windows& windows, std::optional<std::size_t> left_out = std::nullopt);

/// Least number of repetitions with an interval: two may have been disturbed alike.
inline constexpr std::size_t min_for_interval = 3;

/// Summary of the repetitions of one measurement. Times are in seconds.
struct SampleSummary {
  /// The time of the measurement.
  /// - with samples of timing windows: the undisturbed time
  /// - with least times of windows alone: the sum of these
  /// - without windows: the median
  double value = 0;
  double median = 0;  ///< median of the samples; of an even count the mean of the two in the middle
  double least = 0;   ///< least sample
  double largest = 0;           ///< largest sample
  std::size_t count = 0;        ///< number of samples
  std::vector<double> windows;  ///< least time of each timing window; empty: there are none
  /// The time without the best repetition: the largest undisturbed time that results when one
  /// repetition is left out. None unless there are samples of timing windows of two or more.
  std::optional<double> without_best = {};
  bool has_interval() const { return count >= min_for_interval; }
  double half_range() const { return (largest - least) / 2; }
};

/// Summarises one sample or more [s], with the timing windows that they consist of, where known.
SampleSummary summarise(std::span<const double> samples, const Windows& windows = {});

/// Summarises a time. Of a step it is the least sample, and `without_best` the second least.
inline SampleSummary summarise(const Time& time) { return summarise(time.seconds, time.windows); }

/// Largest relative half-width of the interval of a speed-up that is not marked as inconclusive, ≤.
/// An idle machine reaches 0.02.
inline constexpr double max_conclusive_width = 0.05;

/// A speed-up: S = t_reference / t_variant.
struct SpeedUp {
  double value = 0;  ///< ratio S of the times
  /// Limits of the ratio, r = reference, v = variant. They depend on what both sides have:
  /// - without_best: low = r.value / v.without_best and high = r.without_best / v.value, which are
  ///   close where two repetitions or more agree
  /// - least times of as many timing windows, two or more: the 95 % interval of a ratio of sums,
  ///   from pairs of windows, by Student's t (W. G. Cochran: Sampling Techniques, 1977, chapter 6)
  /// - neither: low = r.least / v.largest, high = r.largest / v.least
  double low = 0;
  double high = 0;
  double percent = 0;         ///< improvement 100 (1 - 1/S), from the unrounded S
  bool has_interval = false;  ///< there are enough repetitions for low and high to be an interval

  /// Returns half the width of the interval, divided by the ratio.
  double half_width() const { return (high - low) / 2 / value; }
  /// Returns whether the relative half-width exceeds max_conclusive_width. The report then marks
  /// the number as inconclusive.
  bool inconclusive() const { return has_interval && half_width() > max_conclusive_width; }
};

/// Returns the speed-up: the ratio
/// - of the times, where both have one without the best repetition
/// - else of the sums of least window times, where both have as many windows, two or more
/// - else of the medians
SpeedUp speed_up(const SampleSummary& reference, const SampleSummary& variant);
inline SpeedUp speed_up(const Time& reference, const Time& variant) {
  return speed_up(summarise(reference), summarise(variant));
}

/// Returns the arithmetic mean of each member, also of percentages, as in the last row of the
/// paper's table 2. It has an interval if all sizes have one. sizes: one or more.
SpeedUp mean(std::span<const SpeedUp> sizes);

/// Exponent of t = c n^slope, fitted by least squares to log t as a function of log n.
struct Slope {
  double value = 0;
  double low = 0;   ///< lower end of the 95 % interval by Student's t, n - 2 degrees of freedom
  double high = 0;  ///< upper end of the interval
};

/// Fits a slope. Takes one time per size, since repetitions of a size share its deviation from the
/// line and are no independent evidence. Returns nothing with fewer than three sizes.
std::optional<Slope> fit_slope(std::span<const double> sizes, std::span<const double> seconds);

}  // namespace desmo::report
