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
/// Each window of each analysis gives a point: updates an instant, seconds an instant. Undisturbed
/// points lie on a rising line, since every update costs the same. A disturbance only adds time, so
/// disturbed points lie above that line. The result is read off the lower convex envelope of all
/// points, at the updates an instant of the whole motion. A single point may bound it further: more
/// updates never take less time, nor more than in proportion.
///
/// - windows: with samples, at least two when one is left out
/// - left_out: index of the analysis that is not used
double undisturbed(const Windows& windows, std::optional<std::size_t> left_out = std::nullopt);

/// Repetitions below which there is no interval: two may have been disturbed alike.
inline constexpr std::size_t min_for_interval = 3;

/// The repetitions of one measurement.
struct SampleSummary {
  /// The time.
  /// - with samples of timing windows: the undisturbed time
  /// - with least times of windows alone: the sum of these
  /// - without windows: the median; of a step, the least
  double value = 0;
  double median = 0;  ///< of an even count: the mean of the two in the middle
  double least = 0;
  double largest = 0;
  std::size_t count = 0;
  std::vector<double> windows;  ///< the least time of each; may be empty
  /// The time without its best repetition.
  /// - with two samples of timing windows or more: the largest over all choices of the one left out
  /// - of a step: the second least
  std::optional<double> without_best = {};
  bool has_interval() const { return count >= min_for_interval; }
  double half_range() const { return (largest - least) / 2; }
};

/// Summarises one sample or more, with the windows that they consist of, where known.
SampleSummary summarise(std::span<const double> samples, const Windows& windows = {});

/// Summarises samples of a step, one or more. Its time is the least of them, and without the best
/// repetition the second least, which says how far the least can be had again; of one sample, that.
SampleSummary summarise_step(std::span<const double> samples);

/// Relative half-width of a speed-up's interval beyond which it is called inconclusive. An idle
/// machine reaches 0.02.
inline constexpr double max_conclusive_width = 0.05;

/// A speed-up: S = t_reference / t_variant.
struct SpeedUp {
  double value = 0;  ///< ratio of the times
  /// Limits of the ratio, by what is known of both sides:
  /// - samples of windows, or of a step: the ratios without the best repetition of either side;
  ///   they are close where two repetitions or more agree
  /// - least times of windows: the 95 % interval of a ratio of sums over pairs of windows, by
  ///   Student's t (W. G. Cochran: Sampling Techniques, 1977, chapter 6)
  /// - neither: the reference's least time over the variant's largest, and the reverse
  double low = 0;
  double high = 0;
  double percent = 0;         ///< improvement 100 (1 - 1/S), from the unrounded S
  bool has_interval = false;  ///< there are enough repetitions for low and high to be an interval

  double half_width() const { return (high - low) / 2 / value; }  ///< of the interval, relative
  /// Returns whether the relative half-width exceeds max_conclusive_width. The report then marks
  /// the number as inconclusive.
  bool inconclusive() const { return has_interval && half_width() > max_conclusive_width; }
};

/// Returns the ratio of undisturbed times, where both have samples of windows or as many least
/// times; otherwise the ratio of medians.
SpeedUp speed_up(const SampleSummary& reference, const SampleSummary& variant);

/// Returns the arithmetic mean of each member over the sizes, as in the last row of the paper's
/// table 2, also of percentages; with an interval if all have one. Of one or more.
SpeedUp mean(std::span<const SpeedUp> sizes);

/// t = c n^slope, fitted by least squares in log t over log n.
struct Slope {
  double value = 0;
  double low = 0;  ///< 95 % interval of Student's t, n - 2 degrees of freedom
  double high = 0;
};

/// Takes one point per size (the median), so that repetitions of a size, which share its deviation
/// from the line, are not mistaken for independent evidence. Nothing with fewer than three sizes.
std::optional<Slope> fit_slope(std::span<const double> sizes, std::span<const double> seconds);

}  // namespace desmo::report
