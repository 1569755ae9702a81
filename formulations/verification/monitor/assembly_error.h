#pragma once

#include <optional>
#include <vector>

#include "formulations/base/settings.h"
#include "formulations/model/model.h"

namespace desmo {

/// By how much a group cannot be assembled.
struct AssemblyError {
  GroupId group = -1;
  int constraint = -1;  ///< the one worst satisfied in the position that satisfies all best
  /// How far a point or a distance would have to be moved for it to hold, or, where it joins none,
  /// a component of a direction or an angle.
  double amount = 0;
  bool is_length = false;  ///< in the unit of the mechanism; else a number or rad
};

/// The deficit of the first group that cannot be assembled, at the position nearest to assembly in
/// the least squares of its equations, each over its magnitude, that Levenberg and Marquardt's
/// method finds from there. Nothing when all groups can be, in singular positions too. Not for
/// timed code: it allocates. state: as of the last instant solved, with the drivers of the one that
/// failed.
std::optional<AssemblyError> find_assembly_error(const Model& model, std::vector<double> state,
                                                 const Settings& settings);

}  // namespace desmo
