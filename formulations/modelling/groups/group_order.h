#pragma once

#include <vector>

#include "formulations/modelling/groups/restrictions.h"
#include "formulations/modelling/groups/structure.h"

namespace desmo {

/// Rigid bodies, and restrictions, that belong together; −1: to none (the ground).
struct Components {
  int count = 0;
  std::vector<int> of_body, of_restriction;
};

/// Components as structural groups in solution order: each after those whose bodies its
/// restrictions concern; where that leaves a choice, the group with the first body goes first.
Structure order_groups(const RigidBodies& rigid, const std::vector<Restriction>& restrictions,
                       const Components& components);

}  // namespace desmo
