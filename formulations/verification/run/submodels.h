#pragma once

#include <span>
#include <vector>

#include "formulations/model/members.h"

namespace desmo {

/// A part of a model that is a model by itself, and where its members are in the whole.
struct Submodel {
  Model model;
  Members members;
  std::vector<GroupId> groups;   ///< of the whole, by its own
  std::vector<int> coordinates;  ///< likewise
  std::vector<Level> levels;     ///< of its coordinates; empty: as far as instants
};

/// Cuts a model into submodels that move independently: no equation reads what moves in two of
/// them. Each has all constant groups, and of the fixed entities those that it reads and the
/// outermost points. Empty where all that moves depends on each other. Costs what the submodels do.
/// levels: up to which each coordinate is solved (Plan::levels); may be empty
std::vector<Submodel> independent_submodels(const Model& model, std::span<const Level> levels);

}  // namespace desmo
