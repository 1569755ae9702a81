#pragma once

#include <span>
#include <vector>

#include "cases/io/units.h"
#include "formulations/model/model.h"
#include "formulations/model/scales.h"

namespace desmo {

/// Misfit of an equation: the change of a point, length or direction by which it would hold.
struct Misfit {
  int constraint = no_position;
  /// Distance by which a point, or a length, would have to change for the equation to hold. An
  /// equation without lengths has the change of a direction's component or of an angle instead.
  double amount = 0;
  /// Kind of what would have to change. The amount is in the model's unit of length for points and
  /// distances, in [rad] for angles, in [1] for all others.
  EntityKind kind = EntityKind::vector;
  double relative = 0;  ///< over() the equation's length; compares misfits; 0: not set

  /// Returns the amount divided by a length of the equation; without lengths, the amount itself.
  double over(double length) const { return is_length(kind) ? amount / length : amount; }

  /// Returns the unit in which people read the amount; {"1", 1} where it has none.
  DisplayUnit unit(const DisplayUnits& units) const;
};

/// Returns Φ of a constraint (rows) at a state (state_size).
std::vector<double> residual_of(const Model& model, const Constraint& constraint,
                                std::span<const double> state);

/// Returns the misfit of an equation: |Φ| divided by the steepest slope by a length. Where it has
/// no length, the steepest slope by any operand counts. The kind is that operand's.
/// - constraint, row: the equation
/// - residual: Φ
/// - state: where the slopes are taken (state_size)
Misfit misfit_of(const Model& model, int constraint, int row, double residual,
                 std::span<const double> state);

}  // namespace desmo
