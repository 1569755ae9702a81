#include "report/statistics/windows.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace desmo::report {
namespace {

struct WindowPoint {
  double updates, seconds;  // an instant
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

// With fewer updates than a point it takes no longer, and with more so in proportion at most.
double bound(const WindowPoint& point, double updates) {
  return point.seconds * std::max(1.0, updates / point.updates);
}

// What two points on either side allow: no more than either, nor than the chord between them.
double bound(const WindowPoint& left, const WindowPoint& right, double updates) {
  const double of_one = std::min(bound(left, updates), bound(right, updates));
  const double width = right.updates - left.updates;
  if (width <= 0) return of_one;
  const double share = (updates - left.updates) / width;
  return std::min(of_one, left.seconds + share * (right.seconds - left.seconds));
}

}  // namespace

double undisturbed(const Windows& s, std::optional<std::size_t> left_out) {
  const double instants = std::accumulate(s.instants.begin(), s.instants.end(), 0.0),
               updates = std::accumulate(s.updates.begin(), s.updates.end(), 0.0) / instants;
  const std::vector<WindowPoint> all = points(s, left_out);
  // Of all chords over a place, the lowest there is the envelope's.
  double lowest = std::numeric_limits<double>::infinity();
  for (const WindowPoint& left : all)
    for (const WindowPoint& right : all)
      if (left.updates <= updates && updates <= right.updates)
        lowest = std::min(lowest, bound(left, right, updates));
  return instants * lowest;
}

double undisturbed_without_best(const Windows& s) {
  double largest = 0;
  for (std::size_t r = 0; r < s.samples.size(); ++r) largest = std::max(largest, undisturbed(s, r));
  return largest;
}

}  // namespace desmo::report
