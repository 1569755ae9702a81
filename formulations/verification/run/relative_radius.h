#pragma once

#include <span>

#include "formulations/base/per_level.h"
#include "formulations/model/model.h"
#include "formulations/model/scales.h"
#include "formulations/verification/certificate/certificate.h"

namespace desmo {

/// Largest radii of an instant, over scales and as they are, and the group of the worst.
struct RelativeRadius {
  PerLevel<double> largest{};             ///< over scales
  PerLevel<double> length{}, rotation{};  ///< in their own units
  double worst = 0, of_drivers = 0;       ///< of all coordinates, and of those that are driven
  GroupId group = no_position;

  /// A radius of this part of a scale proves no digit.
  static constexpr double no_digit = 0.5;
  bool proves_no_digit() const { return worst > no_digit; }
  /// Returns why: the drivers' motions have none at the time, or the position is singular.
  ProofFailure failure() const {
    return of_drivers > no_digit ? ProofFailure::time : ProofFailure::singular;
  }
};

/// Returns the largest radii of points, directions, angles and distances, rounded up, over their
/// scales. Infinite radii are left out, unproven or not solved; so are ratios to scales of 0.
RelativeRadius relative_radius(const Model& model, const PerLevel<std::span<const double>>& radius,
                               const Scales& scales);

}  // namespace desmo
