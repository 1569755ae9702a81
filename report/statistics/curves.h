// Measurements of one formulation at several sizes.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "report/read/record.h"

namespace desmo::report {

/// Largest number of coordinates at which growth is judged.
inline constexpr std::int64_t max_linear_coordinates = 10'000;

/// A size that has a time.
struct CurvePoint {
  std::int64_t coordinates = 0, unknowns = 0;
  double seconds = 0;  ///< the least sample, of a step
  double nanoseconds() const { return 1e9 * seconds / static_cast<double>(coordinates); }  ///< each
};

struct Curve {
  std::map<std::int64_t, CurvePoint> points;  ///< by coordinates
  bool failed = false;                        ///< at some other size
};

/// Curves by case and formulation.
using Curves = std::map<std::pair<std::string, std::string>, Curve>;

/// Returns the curves of `growth` or `break_even`.
Curves curves_of(const std::map<CandidateKey, TimedSize>& entries);

/// Returns the point where a coordinate costs least; null without points.
const CurvePoint* cheapest(const Curve& curve);

/// A size that two curves have: its unknowns n, and d = log(t₁/t₂), above 0 where the first is
/// slower.
struct SizeOfBoth {
  double n, d;
};

std::vector<SizeOfBoth> sizes_of_both(const Curve& first, const Curve& second);

/// Returns at each size the faster of the two; where only one has the size, that one.
Curve faster_of(Curve a, const Curve& b);

}  // namespace desmo::report
