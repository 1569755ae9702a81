#pragma once

#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/verification/branch/driver_line.h"

namespace desmo {

/// Returns the drivers' values and rates at a time [s].
PerLevel<std::vector<double>> drivers_at(const Model& model, double time);

/// The motion of a line's drivers as it leaves the line's origin. Knots are those of all drivers.
/// Distances are in the unit of arc.
class Departure {
 public:
  /// start: of the motion [s]: where the drivers are at the origin. Model and line must outlive
  /// this.
  Departure(const Model& model, const DriverLine& line, double start)
      : m_(model), line_(line), start_(start) {}

  /// Returns about the first time at which the drivers are so far away; infinity where they never
  /// are.
  double time_at(double distance) const;

  /// Returns about the time after `time` at which one of the drivers first turns back; `until`
  /// where none does before it. Steps are doubled: a turn and its return between two of them are
  /// not seen.
  double turn_after(double time, double until) const;

  /// Returns whether the drivers' path fails to be tangent to the line at the origin, or the
  /// drivers never reach the distance `far`. near < far: distances at which the path is looked at.
  bool has_corner(double near, double far) const;

 private:
  const Model& m_;
  const DriverLine& line_;
  double start_;
};

}  // namespace desmo
