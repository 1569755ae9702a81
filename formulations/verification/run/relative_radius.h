#pragma once

#include <span>

#include "formulations/base/per_level.h"
#include "formulations/model/model.h"
#include "formulations/model/scales.h"

namespace desmo {

/// Largest radii of an instant, over scales and as they are, and the group of the worst.
struct RelativeRadius {
  PerLevel<double> largest{};             ///< over scales
  PerLevel<double> length{}, rotation{};  ///< in their own units
  double worst = 0;
  GroupId group = no_position;

  /// A radius of this part of a scale proves no digit.
  bool proves_no_digit() const { return worst > 0.5; }
};

/// Returns the largest radii of points, directions, angles and distances, rounded up, over their
/// scales. Infinite radii are left out, unproven or not solved; so are ratios to scales of 0.
RelativeRadius relative_radius(const Model& model, const PerLevel<std::span<const double>>& radius,
                               const Scales& scales);

}  // namespace desmo
