#pragma once

#include <span>
#include <vector>

#include "formulations/base/part.h"
#include "formulations/model/model.h"

namespace desmo {

/// Where a step failed. -1 where it cannot be told.
struct Culprit {
  GroupId group = -1;
  int constraint = -1;  ///< position in Model::constraints
};

/// Finds the group that stopped a part, whatever solved it: the groups are solved again one after
/// the other, from the positions at which the step began, and the first that does not converge,
/// or is singular, is the culprit. Its constraint is the one worst satisfied where it stopped or,
/// if singular, the one most involved in the dependence. Not for timed code: it allocates.
/// state: Model::state_size() values, drivers and earlier parts as of the failed instant.
Culprit find_culprit(const Model& model, std::span<const GroupId> groups, std::vector<double> state,
                     const Settings& settings);

}  // namespace desmo
