#pragma once

#include <optional>
#include <vector>

#include "formulations/base/settings.h"
#include "formulations/model/model.h"

namespace desmo {

/// Closure error of a group that cannot be assembled.
struct AssemblyError {
  GroupId group = no_position;
  /// The worst satisfied constraint at the position that satisfies all best.
  int constraint = no_position;
  /// Distance by which a point, or a length, would have to change for the constraint to hold. A
  /// constraint without lengths has the change of a direction's component or of an angle instead.
  double amount = 0;
  bool is_length = false;  ///< amount is in the mechanism's unit of length; else a number or rad
};

/// Returns the assembly error of the first group that cannot be assembled; nothing when all groups
/// can be, even in a singular position. Levenberg and Marquardt's method minimises the group's
/// equations, each over its magnitude, in least squares. It allocates: keep it out of timed code.
/// - state: the last instant solved, with the drivers of the instant that failed; the start
/// - settings: its tolerance decides whether a group is assembled
std::optional<AssemblyError> find_assembly_error(const Model& model, std::vector<double> state,
                                                 const Settings& settings);

}  // namespace desmo
