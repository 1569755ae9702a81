#pragma once

#include <span>
#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/base/reference_instant.h"
#include "formulations/model/model.h"

namespace desmo {

/// Points and distances are lengths; vectors (directions) and angles are not.
bool is_length(EntityKind kind);

/// Size of a mechanism in its unit of length, positive: the diagonal of the smallest box, along the
/// axes, that holds all points in the nominal position, or the largest nominal distance when that
/// is larger; 1 when there is neither.
double nominal_size(const Model& model);

/// For each coordinate, the magnitude that a change of it is judged by: the nominal size for those
/// of points and distances, 1 for those of vectors and angles.
std::vector<double> natural_magnitudes(const Model& model);

/// Largest values of a motion, by which errors and corrections become numbers without unit: the
/// same in metres and in millimetres.
///
///                  points, distances                directions, angles
///   position       nominal size of the mechanism    1, 1 rad
///   velocity       largest speed of any of them     largest rate
///   acceleration   largest                          largest
///
/// Where one kind does not move its velocity scale is the other's, times or over the size; where
/// nothing accelerates the acceleration scale is velocity² over the position scale. What neither
/// gives is 0: nothing moves.
struct Scales {
  PerLevel<double> length{1, 0, 0};    ///< unit of length, over s, over s²
  PerLevel<double> rotation{1, 0, 0};  ///< 1 or rad, over s, over s²

  double of(EntityKind kind, Level level) const {
    return is_length(kind) ? length[level] : rotation[level];
  }
};

/// Scales of the motion that a reference samples.
Scales make_scales(const Model& model, std::span<const ReferenceInstant> reference);

/// |difference| of two values by their scale; 0 / 0 is no error, and NaN is an infinite one.
double relative(double difference, double scale);

}  // namespace desmo
