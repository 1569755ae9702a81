// Measurements of one formulation at several sizes.
#pragma once

#include <cstdint>
#include <map>
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

/// Returns the curves of every case and formulation of `growth` or `break_even`.
std::vector<Curve> curves_of(const std::map<CandidateKey, TimedSize>& entries);

/// Returns the point where a coordinate costs least; null without points.
const CurvePoint* cheapest(const Curve& curve);

/// A size that two curves have: its unknowns n, and by what the first is slower, d = log(t₁/t₂).
struct SizeOfBoth {
  double n, d;
};

std::vector<SizeOfBoth> sizes_of_both(const Curve& first, const Curve& second);

/// At each size the faster of the two; where only one has it, that one.
Curve faster_of(const Curve& a, const Curve& b);

// ---- caches ----

struct Cache {
  std::string name;  ///< "L2"
  double bytes = 0;
};

/// Returns the caches that hold data, smallest first. They are read from texts such as "L2 Unified
/// 1024 KiB, shared by 1"; others are left out.
std::vector<Cache> data_caches(const Machine& machine);

}  // namespace desmo::report
