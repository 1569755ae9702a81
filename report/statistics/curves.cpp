#include "report/statistics/curves.h"

#include <algorithm>
#include <iterator>
#include <ranges>

namespace desmo::report {

std::vector<Curve> curves_of(const std::map<CandidateKey, TimedSize>& entries) {
  std::map<std::pair<std::string, std::string>, Curve> curves;  // entries of a case are by size
  for (const auto& [key, entry] : entries) {
    Curve& curve = curves[{key.case_name, key.id}];
    curve.case_name = key.case_name;
    curve.id = key.id;
    if (entry.status == Status::ok)
      curve.points.push_back(
          {key.coordinates, &entry, *std::ranges::min_element(entry.seconds_per_step)});
    else
      curve.failed = true;
  }
  std::vector<Curve> all;
  std::ranges::move(curves | std::views::values, std::back_inserter(all));
  return all;
}

const CurvePoint* cheapest(const Curve& curve) {
  const auto least = std::ranges::min_element(curve.points, {}, &CurvePoint::nanoseconds);
  return least == curve.points.end() ? nullptr : &*least;
}

const CurvePoint* end_of_growth(const Curve& curve) {
  const CurvePoint *const least = cheapest(curve), *end = nullptr;
  for (const CurvePoint& point : curve.points | std::views::reverse) {
    if (&point <= least || point.nanoseconds() <= dearer * least->nanoseconds()) break;
    end = &point;
  }
  return end;
}

}  // namespace desmo::report
