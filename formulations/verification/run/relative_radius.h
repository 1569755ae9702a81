#pragma once

#include <array>
#include <span>

#include "formulations/base/per_level.h"
#include "formulations/model/model.h"
#include "formulations/model/scales.h"

namespace desmo {

/// The largest norm of some entities, and the group of the one that has it.
struct MaxNorm {
  double norm = 0;
  GroupId group = no_position;
};

/// Returns the largest norms of values (coordinates) of entities that move: of directions and
/// angles, then of points and distances. Leaves out those that are not finite.
std::array<MaxNorm, 2> max_norms(const Model& model, std::span<const double> values);

/// Largest radii of an instant, over scales and in their own units.
struct RelativeRadius {
  PerLevel<double> largest{};             ///< over scales
  PerLevel<double> length{}, rotation{};  ///< in their own units
  double worst = 0;                       ///< maximum of `largest`
  GroupId group = no_position;            ///< structural group of the worst

  /// Returns whether a radius exceeds half of its scale: then no digit is proven.
  bool proves_no_digit() const { return worst > 0.5; }
};

/// Returns the largest radii of points, directions, angles and distances, rounded up. Leaves out
/// infinite radii, which are unproven or not solved, and ratios to scales of 0.
RelativeRadius relative_radius(const Model& model, const PerLevel<std::span<const double>>& radius,
                               const Scales& scales);

}  // namespace desmo
