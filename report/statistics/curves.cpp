#include "report/statistics/curves.h"

#include <algorithm>
#include <cmath>
#include <ranges>

namespace desmo::report {

Curves curves_of(const std::map<CandidateKey, TimedSize>& entries) {
  Curves curves;
  for (const auto& [key, entry] : entries) {
    Curve& curve = curves[{key.case_name, key.id}];
    if (entry.status == Status::ok)
      curve.points[key.coordinates] = {key.coordinates, entry.unknowns,
                                       std::ranges::min(entry.time.seconds)};
    else
      curve.failed = true;
  }
  return curves;
}

const CurvePoint* cheapest(const Curve& curve) {
  const auto points = curve.points | std::views::values;
  const auto least = std::ranges::min_element(points, {}, &CurvePoint::nanoseconds);
  return least == points.end() ? nullptr : &*least;
}

std::vector<SizeOfBoth> sizes_of_both(const Curve& first, const Curve& second) {
  std::vector<SizeOfBoth> all;
  for (const auto& [coordinates, a] : first.points)
    if (const auto b = second.points.find(coordinates); b != second.points.end())
      all.push_back({static_cast<double>(a.unknowns), std::log(a.seconds / b->second.seconds)});
  return all;
}

Curve faster_of(Curve a, const Curve& b) {
  for (const auto& [coordinates, point] : b.points) {
    CurvePoint& faster = a.points.try_emplace(coordinates, point).first->second;
    if (point.seconds < faster.seconds) faster = point;
  }
  return a;
}

}  // namespace desmo::report
