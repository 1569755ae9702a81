#pragma once

#include <span>
#include <vector>

#include "formulations/model/model.h"

namespace desmo {

/// Misfit of an equation: the change of a point, length or direction by which it would hold.
struct Misfit {
  int constraint = no_position;
  /// Distance by which a point, or a length, would have to change for the equation to hold. An
  /// equation without lengths has the change of a direction's component or of an angle instead.
  double amount = 0;
  /// true: amount is in the model's unit of length; false: in [1] or [rad]
  bool is_length = false;
  double relative = 0;  ///< in checked runs over() the equation's length, by which misfits compare

  /// Returns the amount divided by a length of the equation; without lengths, the amount itself.
  double over(double length) const { return is_length ? amount / length : amount; }
};

/// Returns Φ of a constraint (rows) at a state (state_size).
std::vector<double> residual_of(const Model& model, const Constraint& constraint,
                                std::span<const double> state);

/// Returns the misfit of an equation: |Φ| divided by the steepest slope by a length. Where it has
/// no length, the steepest slope by any operand counts.
/// - constraint, row: the equation
/// - residual: Φ
/// - state: where the slopes are taken (state_size)
Misfit misfit_of(const Model& model, int constraint, int row, double residual,
                 std::span<const double> state);

}  // namespace desmo
