#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/verification/certificate/certified_instant.h"
#include "formulations/verification/certificate/hermite.h"
#include "formulations/verification/certificate/lane_numbers.h"

namespace desmo {

/// The path of a coordinate and the tube about it, in two registers.
struct alignas(32) CoordinatePath {
  Quintic<double> path{};
  double gap = 0;     ///< from the path to the instants
  double radius = 0;  ///< of the tube; infinite: not proven

  void set(const LaneNumbers& low, const LaneNumbers& high) {
    low.store(path.data());
    high.store(path.data() + LaneNumbers::count);  // and what follows it
  }
};
static_assert(sizeof(CoordinatePath) == 8 * sizeof(double));

/// Time along a path, s in [−1, 1]: middle + half s, with exact doubles whose range covers both
/// ends.
struct TimeSpan {
  double middle, half;

  TimeSpan(double from, double to) : middle(from + (to - from) / 2) {
    half = std::nextafter(std::max(to - middle, middle - from), INFINITY);
  }
  double s(double time) const { return (time - middle) / half; }
  double time(double s) const { return middle + half * s; }
};

/// The paths of all coordinates over a step: what a tube lies about.
class CoordinatePaths {
 public:
  /// The model must outlive this.
  explicit CoordinatePaths(const Model& m) : m_(m), rows_(m.coordinates()) {}

  /// Lays the paths through two instants; those of driven coordinates are Taylor polynomials of
  /// their motions. Radii are infinite where they are not those of drivers.
  void find(const CertifiedInstant& from, const CertifiedInstant& to);

  const TimeSpan& span() const { return span_; }
  CoordinatePath& operator[](int coordinate) { return rows_[coordinate]; }
  const CoordinatePath& operator[](int coordinate) const { return rows_[coordinate]; }

 private:
  void find_between(const CertifiedInstant& from, const CertifiedInstant& to);
  void find_drivers();

  const Model& m_;
  TimeSpan span_{-1, 1};
  std::vector<CoordinatePath> rows_;
};

}  // namespace desmo
