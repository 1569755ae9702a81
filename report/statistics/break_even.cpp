#include "report/statistics/break_even.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>

namespace desmo::report {
namespace {

/// A size that both have: its unknowns n, and by what the first is slower, d = log(t₁/t₂).
struct Both {
  double n, d;
};

std::vector<Both> common(const Curve& first, const Curve& second) {
  std::vector<Both> all;
  for (const CurvePoint& a : first.points)
    for (const CurvePoint& b : second.points)
      if (a.coordinates == b.coordinates)
        all.push_back({static_cast<double>(a.entry->unknowns), std::log(a.seconds / b.seconds)});
  return all;
}

/// Where d, linear in log n, becomes zero.
double zero_between(const Both& a, const Both& b) {
  return a.n * std::pow(b.n / a.n, a.d / (a.d - b.d));
}

}  // namespace

CurveComparison compare(const Curve& first, const Curve& second) {
  const std::vector<Both> all = common(first, second);
  CurveComparison r{.sizes = all.size(), .break_even = std::nullopt};
  if (all.empty()) return r;
  r.smallest = all.front().n;
  r.largest = all.back().n;
  r.second_faster_at_largest = all.back().d > 0;
  for (std::size_t i = 1; i < all.size() && r.second_faster_at_largest; ++i) {
    if ((all[i - 1].d > 0) == (all[i].d > 0)) continue;
    if (!r.break_even) r.break_even = {.low = all[i - 1].n};
    r.break_even->unknowns = zero_between(all[i - 1], all[i]);  // the last is the one that holds
    r.break_even->high = all[i].n;
  }
  return r;
}

Curve faster_of(const Curve& a, const Curve& b) {
  std::map<std::int64_t, CurvePoint> fastest;
  for (const Curve* curve : {&a, &b})
    for (const CurvePoint& point : curve->points) {
      const auto [place, is_new] = fastest.emplace(point.coordinates, point);
      if (!is_new && point.seconds < place->second.seconds) place->second = point;
    }
  Curve faster{a.case_name, a.id + " or " + b.id, {}, a.failed || b.failed};
  for (const CurvePoint& point : fastest | std::views::values) faster.points.push_back(point);
  return faster;
}

}  // namespace desmo::report
