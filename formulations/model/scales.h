#pragma once

#include <span>
#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/base/reference_instant.h"
#include "formulations/model/model.h"

namespace desmo {

/// Returns whether entities of a kind are lengths: points and distances are; vectors (directions),
/// angles and orientations are not.
constexpr bool is_length(EntityKind kind) {
  return kind == EntityKind::point || kind == EntityKind::distance;
}

/// Returns the size of a mechanism in its unit of length: the diagonal of the axis-parallel box
/// around all points in the nominal position. A larger nominal value of a distance coordinate
/// between points replaces it. How far the points are from the origin does not matter. Returns 1
/// where this size is 0.
double nominal_size(const Model& model);

/// Returns the nominal magnitude of each coordinate: the nominal size for points and distances, 1
/// for vectors and angles. (Natural magnitudes, of Magnitudes, go by the lengths of the bodies
/// nearby.)
std::vector<double> nominal_magnitudes(const Model& model);

/// Scales of a motion, its largest values. Errors divided by scales have no unit: they are the same
/// in metres and in millimetres.
///
///                  points, distances                directions, angles
///   position       nominal size of the mechanism    1, 1 rad
///   velocity       largest speed                    largest rate
///   acceleration   largest acceleration             largest second derivative
///
/// A column without motion has the velocity scale of the other column, multiplied or divided by the
/// size. A column without acceleration has its velocity scale squared, divided by its position
/// scale. The scales of rates are 0 when nothing moves.
struct Scales {
  PerLevel<double> length{1, 0, 0};    ///< [unit of length], per s, per s²
  PerLevel<double> rotation{1, 0, 0};  ///< [1] or [rad], per s, per s²

  double of(EntityKind kind, Level level) const {
    return is_length(kind) ? length[level] : rotation[level];
  }
};

/// Computes the scales of the motion that a reference samples.
Scales make_scales(const Model& model, std::span<const ReferenceInstant> reference);

/// Returns |difference| / scale; 0 where the difference is 0, infinity where the quotient is NaN.
double relative(double difference, double scale);

}  // namespace desmo
