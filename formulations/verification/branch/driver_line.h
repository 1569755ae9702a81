#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "formulations/model/model.h"

namespace desmo {

/// A straight line in the space of drivers: z = origin + s rates, in the unit of each driver. Its
/// arc s is the norm ‖Δz / nominal magnitudes‖₂: for a single angle, s = 1 is 1 rad.
struct DriverLine {
  /// - q: positions of all coordinates at the origin
  /// - direction: rates of the drivers, of any length
  /// - group: only the drivers that this group depends on move and count in distances; the others
  ///   stay at the origin. no_position: all drivers
  DriverLine(const Model& model, std::span<const double> q, std::span<const double> direction,
             GroupId group = no_position);

  bool exists() const;  ///< false: the direction has no length, or is not finite
  /// Returns whether a driver is one of the line's.
  bool counts(std::size_t driver) const { return magnitudes[driver] < INFINITY; }
  /// Returns the number of the line's drivers.
  std::ptrdiff_t count() const;
  /// Returns the arc that a change Δz of the drivers covers along the line (inner product).
  double along(std::span<const double> change) const;
  /// Returns the arc of the point of the line that is nearest to the drivers.
  double arc(std::span<const double> z) const;
  /// Returns the point at an arc.
  std::vector<double> at(double s) const;
  /// Returns the distance of the drivers from the line's point at an arc.
  double distance(std::span<const double> z, double s) const;
  /// Replaces the motions of a model's drivers: they go along the line, with the arc as time.
  void lead(Model& model) const;

  /// Nominal magnitude, value at the origin and rate dz/ds of each driver (drivers). A driver that
  /// is none of the line's has an infinite magnitude and rate 0.
  std::vector<double> magnitudes, origin, rates;
};

}  // namespace desmo
