#pragma once

#include <memory>

#include "formulations/model/characteristic_lengths.h"
#include "formulations/model/model.h"
#include "formulations/verification/range/block_determinants.h"
#include "formulations/verification/range/double_roots.h"
#include "formulations/verification/range/range_limits.h"
#include "formulations/verification/range/solution_curve.h"

namespace desmo {

/// A curve by the equations that a model keeps, and what is evaluated along it.
struct FollowedCurve {
  /// driver: position in Model::drivers. The model must outlive the curve.
  FollowedCurve(const Model& m, int driver, const RangeLimits& limits);
  /// Like the other constructor, but the curve owns the model.
  FollowedCurve(std::unique_ptr<const Model> m, int driver, const RangeLimits& limits);

  /// Returns whether the misfit of a left-out equation over its length exceeds max_misfit. The
  /// point is then on another branch, or the kept equations allow what the left-out one forbids.
  bool is_violated(const SolutionCurve::Point& point) const;

  std::unique_ptr<const Model> own;  // the model, if equations were chosen anew
  const Model& model;
  SolutionCurve curve;
  BlockDeterminants determinants{model};
  DoubleRootSearch double_roots{curve, determinants};
  const CharacteristicLengths lengths{model};
  const double driver_magnitude;  // nominal magnitude of the driver
  const bool is_driver_positive;  // the driver is the distance of two points
};

}  // namespace desmo
