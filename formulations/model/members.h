#pragma once

#include <vector>

#include "formulations/model/model.h"

namespace desmo {

/// Members of a model that are a model by themselves: positions in the whole, ascending. The
/// entities include all that the constraints read and the drivers drive.
struct Members {
  std::vector<EntityId> entities;
  std::vector<int> constraints;
  std::vector<int> drivers;
};

/// Returns the groups of a whole model that its members are of, ascending.
std::vector<GroupId> groups_of(const Model& whole, const Members& members);

/// Returns the model of some members of a whole one, in the same order, and of their groups. Its
/// time grows with the members and their groups, not with the whole model.
Model model_of(const Model& whole, const Members& members);

}  // namespace desmo
