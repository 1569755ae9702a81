#pragma once

#include <span>
#include <vector>

#include "formulations/model/members.h"

namespace desmo {

/// Members of a model that are a model by themselves, and their positions in the whole.
struct Submodel {
  Model model;
  Members members;
  std::vector<GroupId> groups;   ///< position in the whole model of each of its groups
  std::vector<int> coordinates;  ///< position in the whole model of each of its coordinates
  /// Level up to which each of `coordinates` is solved; empty: that of the instant, for all.
  std::vector<Level> levels;
};

/// Cuts a model into submodels that move independently: no equation reads moving entities of two of
/// them. Each has all constant groups, the fixed entities that it reads, and the outermost fixed
/// points. Returns nothing if the model cannot be cut. Costs as much as making the submodels.
/// levels: level up to which each coordinate is solved (Plan::levels); may be empty
std::vector<Submodel> independent_submodels(const Model& model, std::span<const Level> levels);

}  // namespace desmo
