#pragma once

#include <string>
#include <vector>

#include "cases/mechanism.h"

namespace desmo {

/// How the unknowns are cut.
enum class Partition {
  global,  ///< all structural groups at once
  group,   ///< the structural groups one after the other
};

/// How equations are evaluated.
enum class Evaluation {
  automatic,  ///< by a loop over constraint objects
  symbolic,   ///< by generated straight-line code
};

/// What one part of a formulation solves: whole groups, whose equations are stacked in the order
/// of the groups.
struct PartDefinition {
  std::vector<GroupId> groups;
  std::vector<int> unknowns;   ///< coordinates solved for, ascending
  std::vector<int> equations;  ///< positions in Mechanism::constraints
  bool constant = false;       ///< depends on no driver: solved once, at assembly
};

/// The parts of a partition in solution order; constant groups come first, each on its own.
/// Throws std::invalid_argument when a group needs a coordinate that is found after it.
std::vector<PartDefinition> make_partition(const Mechanism& mechanism, Partition partition);

/// For each coordinate, whether it belongs to a constant group.
std::vector<bool> constant_coordinates(const Mechanism& mechanism);

/// For each scalar equation of a part, the constraint (position in Mechanism::constraints).
std::vector<int> constraint_of_row(const Mechanism& mechanism, const PartDefinition& part);

}  // namespace desmo
