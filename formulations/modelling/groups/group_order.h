#pragma once

#include <vector>

#include "formulations/modelling/groups/restrictions.h"
#include "formulations/modelling/groups/structure.h"

namespace desmo {

/// Components of the mechanism: the component of each rigid body and of each restriction; −1: none
/// (the ground).
struct Components {
  int count = 0;
  std::vector<int> of_body, of_restriction;
};

/// Returns the components as structural groups in solution order. A group comes after the groups
/// whose bodies its restrictions involve. Ties are broken by the groups' first bodies.
Structure order_groups(const RigidBodies& rigid, const std::vector<Restriction>& restrictions,
                       const Components& components);

}  // namespace desmo
