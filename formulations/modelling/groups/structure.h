#pragma once

#include <vector>

#include "formulations/modelling/bodies/rigid_bodies.h"

namespace desmo {

/// A structural group: the fewest bodies that are determined together, once the groups before it
/// are solved.
struct StructuralGroup {
  std::vector<int> bodies;  ///< positions in RigidBodies::list, ascending
  std::vector<int> after;   ///< groups to whose bodies it is joined, ascending
  int freedoms = 0;         ///< of its bodies
  int restrictions = 0;  ///< of its joints and drivers; more than freedoms when some are redundant
};

struct Structure {
  std::vector<StructuralGroup> groups;  ///< in solution order; otherwise by their first body
  std::vector<int> of_body;             ///< of each rigid body; -1: the ground
};

/// The structural groups of a mechanism: strong components of a maximum matching between the
/// freedoms of its bodies and the restrictions of its joints and drivers (Dulmage & Mendelsohn
/// 1958; paper, eq. 1). Where there are more restrictions than freedoms, all bodies concerned are
/// one group; whether the surplus is consistent is not seen from the structure.
/// Throws std::invalid_argument, naming bodies and coordinates, when bodies are left that nothing
/// determines: a driver is missing.
Structure find_structure(const Mechanism& mechanism, const RigidBodies& rigid);

}  // namespace desmo
