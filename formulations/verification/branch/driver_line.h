#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "formulations/model/model.h"

namespace desmo {

/// A straight line in the space of drivers: z = origin + s rates, in the unit of each driver. s is
/// its arc, ‖Δz‖ over nominal magnitudes: 1 rad of a single angle.
struct DriverLine {
  /// - q: positions of all coordinates at its origin
  /// - direction: of the drivers, of any length
  /// - group: the line is one of the drivers that it depends on; the others stay at the origin, and
  ///   no distance counts them. no_position: of all
  DriverLine(const Model& model, std::span<const double> q, std::span<const double> direction,
             GroupId group = no_position);

  bool exists() const;  ///< false: the direction is none
  /// Returns whether a driver is one of the line's.
  bool counts(std::size_t driver) const { return magnitudes[driver] < INFINITY; }
  /// Returns the number of the line's drivers.
  std::ptrdiff_t count() const;
  /// Returns the part of a change of the drivers along the line.
  double along(std::span<const double> change) const;
  /// Returns the arc of the point of the line that is nearest to the drivers.
  double arc(std::span<const double> z) const;
  /// Returns the point at an arc.
  std::vector<double> at(double s) const;
  /// Returns the distance of the drivers from the line's point at an arc.
  double distance(std::span<const double> z, double s) const;
  /// Lets the drivers of a model go along the line: its time is the arc.
  void lead(Model& model) const;

  /// Numbers of each driver; one that is none of the line's has an infinite magnitude.
  std::vector<double> magnitudes, origin, rates;
};

}  // namespace desmo
