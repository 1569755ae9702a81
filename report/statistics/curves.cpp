#include "report/statistics/curves.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ranges>
#include <sstream>

namespace desmo::report {

std::vector<Curve> curves_of(const std::map<CandidateKey, TimedSize>& entries) {
  std::map<std::pair<std::string, std::string>, Curve> curves;  // entries of a case are by size
  for (const auto& [key, entry] : entries) {
    Curve& curve = curves[{key.case_name, key.id}];
    curve.case_name = key.case_name;
    curve.id = key.id;
    if (entry.status == Status::ok)
      curve.points.push_back(
          {key.coordinates, &entry, *std::ranges::min_element(entry.time.seconds)});
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

std::vector<SizeOfBoth> sizes_of_both(const Curve& first, const Curve& second) {
  std::vector<SizeOfBoth> all;
  for (const CurvePoint& a : first.points)
    for (const CurvePoint& b : second.points)
      if (a.coordinates == b.coordinates)
        all.push_back({static_cast<double>(a.entry->unknowns), std::log(a.seconds / b.seconds)});
  return all;
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

std::vector<Cache> data_caches(const Machine& machine) {
  std::vector<Cache> caches;
  for (const std::string& text : machine.caches) {
    std::istringstream words(text);
    std::string name, type, unit;
    double size = 0;
    if (words >> name >> type >> size >> unit && type != "Instruction" && unit.starts_with("KiB") &&
        size > 0)
      caches.push_back({name, 1024 * size});
  }
  std::ranges::stable_sort(caches, {}, &Cache::bytes);
  return caches;
}

}  // namespace desmo::report
