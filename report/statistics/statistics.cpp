#include "report/statistics/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace desmo::report {
namespace {

// Two-sided 95 % quantiles of Student's t for 1, 2, ... degrees of freedom, to three decimals as
// printed tables have them. Exact quantiles would change last digits of intervals in reports.
constexpr std::array student_quantiles{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306,
                                       2.262,  2.228, 2.201, 2.179, 2.160, 2.145, 2.131, 2.120,
                                       2.110,  2.101, 2.093, 2.086, 2.080, 2.074, 2.069, 2.064,
                                       2.060,  2.056, 2.052, 2.048, 2.045, 2.042};

// Returns the quantile for that many degrees of freedom, ≥ 1. For more than the table has, it is
// the table's last one, which is at most 4.2 % too large.
double student(std::size_t freedom) {
  return student_quantiles[std::min(freedom, student_quantiles.size()) - 1];
}

std::vector<double> logarithms(std::span<const double> values) {
  std::vector<double> result;
  for (const double value : values) result.push_back(std::log(value));
  return result;
}

double sum(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double average(std::span<const double> values) {
  return sum(values) / static_cast<double>(values.size());
}

// Returns half the width of the 95 % interval of S = Σa / Σb for n pairs of windows (a, b), n ≥ 2:
// t √(n/(n-1) Σ(a - S b)²) / Σb.
double half_width_of_ratio(std::span<const double> a, std::span<const double> b) {
  const std::size_t n = a.size();
  const double ratio = sum(a) / sum(b), all = static_cast<double>(n);
  double squares = 0;
  for (std::size_t i = 0; i < n; ++i) squares += std::pow(a[i] - ratio * b[i], 2);
  return student(n - 1) * std::sqrt(squares * all / (all - 1)) / sum(b);
}

struct WindowPoint {
  double updates, seconds;  // number of updates, and time [s], per instant
};

std::vector<WindowPoint> points(const Windows& s, std::optional<std::size_t> left_out) {
  std::vector<WindowPoint> points;
  for (std::size_t k = 0; k < s.updates.size(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t r = 0; r < s.samples.size(); ++r)
      if (r != left_out) least = std::min(least, s.samples[r][k]);
    points.push_back({s.updates[k] / s.instants[k], least / s.instants[k]});
  }
  return points;
}

// Returns the largest undisturbed time per instant that a point allows for `updates` per instant:
// the point's own time; for more updates than the point has, its time in proportion to them.
double bound(const WindowPoint& point, double updates) {
  return point.seconds * std::max(1.0, updates / point.updates);
}

// Returns the bound by two points, one with fewer updates and one with more: the least of their two
// bounds and of the chord between them.
double bound(const WindowPoint& left, const WindowPoint& right, double updates) {
  const double of_one = std::min(bound(left, updates), bound(right, updates));
  const double width = right.updates - left.updates;
  if (width <= 0) return of_one;
  const double share = (updates - left.updates) / width;
  return std::min(of_one, left.seconds + share * (right.seconds - left.seconds));
}

}  // namespace

double undisturbed(const Windows& s, std::optional<std::size_t> left_out) {
  const double instants = sum(s.instants), updates = sum(s.updates) / instants;
  const std::vector<WindowPoint> all = points(s, left_out);
  // The lower envelope at `updates` is the lowest of all chords that reach over it.
  double lowest = std::numeric_limits<double>::infinity();
  for (const WindowPoint& left : all)
    for (const WindowPoint& right : all)
      if (left.updates <= updates && updates <= right.updates)
        lowest = std::min(lowest, bound(left, right, updates));
  return instants * lowest;
}

SampleSummary summarise(std::span<const double> samples, const Windows& windows) {
  std::vector<double> sorted(samples.begin(), samples.end());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t n = sorted.size();
  const double median = (sorted[(n - 1) / 2] + sorted[n / 2]) / 2;
  SampleSummary s{.value = median,
                  .median = median,
                  .least = sorted.front(),
                  .largest = sorted.back(),
                  .count = n,
                  .windows = windows.least};
  if (windows.least.empty()) return s;
  s.value = windows.samples.empty() ? sum(windows.least) : undisturbed(windows);
  if (windows.samples.size() > 1)
    for (std::size_t r = 0; r < windows.samples.size(); ++r)
      s.without_best = std::max(s.without_best.value_or(0), undisturbed(windows, r));
  return s;
}

SpeedUp speed_up(const SampleSummary& reference, const SampleSummary& variant) {
  const bool sampled = reference.without_best && variant.without_best;
  const bool paired =
      reference.windows.size() > 1 && reference.windows.size() == variant.windows.size();
  // S = t_global / t_topological
  const double ratio = sampled  ? reference.value / variant.value
                       : paired ? sum(reference.windows) / sum(variant.windows)
                                : reference.median / variant.median;
  SpeedUp s{.value = ratio,
            .low = reference.least / variant.largest,
            .high = reference.largest / variant.least,
            .percent = 100 * (1 - 1 / ratio),
            .has_interval = reference.has_interval() && variant.has_interval()};
  if (sampled) {
    s.low = reference.value / *variant.without_best;
    s.high = *reference.without_best / variant.value;
    return s;
  }
  if (!paired) return s;
  const double half = half_width_of_ratio(reference.windows, variant.windows);
  s.low = std::max(0.0, ratio - half);
  s.high = ratio + half;
  return s;
}

SpeedUp mean(std::span<const SpeedUp> sizes) {
  SpeedUp result{.has_interval = true};
  const double n = static_cast<double>(sizes.size());
  for (const SpeedUp& size : sizes) {
    result.value += size.value / n;
    result.low += size.low / n;
    result.high += size.high / n;
    result.percent += size.percent / n;
    result.has_interval = result.has_interval && size.has_interval;
  }
  return result;
}

std::optional<Slope> fit_slope(std::span<const double> sizes, std::span<const double> seconds) {
  const std::size_t n = sizes.size();
  if (n < 3) return std::nullopt;
  const std::vector<double> x = logarithms(sizes), y = logarithms(seconds);
  const double x_mean = average(x), y_mean = average(y);
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < n; ++i) {
    xx += (x[i] - x_mean) * (x[i] - x_mean);
    xy += (x[i] - x_mean) * (y[i] - y_mean);
  }
  const double slope = xy / xx;
  double squares = 0;  // sum of the squares of residuals
  for (std::size_t i = 0; i < n; ++i)
    squares += std::pow(y[i] - y_mean - slope * (x[i] - x_mean), 2);
  const double freedom = static_cast<double>(n - 2);
  const double half = student(n - 2) * std::sqrt(squares / freedom / xx);  // t sqrt(s^2 / S_xx)
  return Slope{.value = slope, .low = slope - half, .high = slope + half};
}

}  // namespace desmo::report
