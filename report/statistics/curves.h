// What was measured of one formulation at several sizes.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "report/read/record.h"

namespace desmo::report {

/// Up to so many coordinates growth is judged.
inline constexpr std::int64_t max_linear_coordinates = 10'000;

/// A size that has a time. `entry` refers to the record.
struct CurvePoint {
  std::int64_t coordinates = 0;
  const TimedSize* entry = nullptr;
  double seconds = 0;  ///< the least sample, of a step
  double nanoseconds() const { return 1e9 * seconds / static_cast<double>(coordinates); }  ///< each
};

struct Curve {
  std::string case_name, id;
  std::vector<CurvePoint> points;  ///< by size
  bool failed = false;             ///< at some other size
};

/// Of every case and formulation of `growth` or `crossing`.
std::vector<Curve> curves_of(const std::map<CandidateKey, TimedSize>& entries);

/// Where a coordinate costs least; null without points.
const CurvePoint* cheapest(const Curve& curve);

/// How many times its least a coordinate costs where growth has ended.
inline constexpr double dearer = 1.25;

/// The first size beyond the cheapest from which on a coordinate is dearer, at every size; null
/// where there is none.
const CurvePoint* end_of_growth(const Curve& curve);

}  // namespace desmo::report
