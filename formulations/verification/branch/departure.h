#pragma once

#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/verification/branch/driver_line.h"

namespace desmo {

/// Returns the drivers' values and rates at a time [s].
PerLevel<std::vector<double>> drivers_at(const Model& model, double time);

/// Returns the drivers' values at a time [s] in compensated arithmetic, as certificates have them.
/// Doubles, as in drivers_at(), lose digits at a late time or a large phase.
std::vector<double> exact_drivers_at(const Model& model, double time);

/// The motion of the drivers as it leaves the origin of a line. Only the line's drivers count.
/// Distances are in the unit of the line's arc.
class Departure {
 public:
  /// start: time at which the drivers are at the line's origin [s]. Model and line must outlive
  /// this object.
  Departure(const Model& model, const DriverLine& line, double start)
      : m_(model), line_(line), start_(start) {}

  /// Returns about the first time [s] at which the drivers are at least `distance` away from the
  /// origin; infinity if they never are.
  double time_at(double distance) const;

  /// Returns whether the path of several drivers leaves the origin in another direction than the
  /// line. Where a path is tangent to the line, the angle between them falls to zero with the
  /// distance. So there is a corner if the angle at the distance `near` exceeds half of that at
  /// `far` > `near`, beyond rounding. Also returns true if the drivers never reach `far`. A single
  /// driver has no corner.
  bool has_corner(double near, double far) const;

 private:
  const Model& m_;
  const DriverLine& line_;
  double start_;
};

}  // namespace desmo
