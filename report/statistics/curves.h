// Measurements of one formulation at several sizes.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "report/read/record.h"

namespace desmo::report {

/// Largest number of coordinates of the points to which an exponent of growth is fitted, ≤.
inline constexpr std::int64_t max_linear_coordinates = 10'000;

/// A size that has a time.
struct CurvePoint {
  std::int64_t coordinates = 0, unknowns = 0;
  double seconds = 0;  ///< time of a step: its least sample
  /// Returns the time of a step, divided by the number of coordinates [ns].
  double nanoseconds() const { return 1e9 * seconds / static_cast<double>(coordinates); }
};

/// The times of one formulation at the sizes of a case.
struct Curve {
  std::map<std::int64_t, CurvePoint> points;  ///< points by their numbers of coordinates
  bool failed = false;                        ///< at least one size has no time
};

/// Curves by case and id of the formulation.
using Curves = std::map<std::pair<std::string, std::string>, Curve>;

/// Returns the curves of entries, Record::growth or Record::break_even.
Curves curves_of(const std::map<CandidateKey, TimedSize>& entries);

/// Returns the point with the least time per coordinate; null without points.
const CurvePoint* cheapest(const Curve& curve);

/// A size that two curves have: its number n of unknowns, and d = log(t₁/t₂) of their times, above
/// 0 where the first is slower.
struct SizeOfBoth {
  double n, d;
};

std::vector<SizeOfBoth> sizes_of_both(const Curve& first, const Curve& second);

/// Returns the curve that has at each size the faster point of the two; where only one curve has
/// the size, that point. Curve::failed is that of `a`.
Curve faster_of(Curve a, const Curve& b);

}  // namespace desmo::report
