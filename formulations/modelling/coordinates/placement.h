#pragma once

#include <vector>

#include "formulations/modelling/bodies/rigid_bodies.h"
#include "formulations/modelling/groups/structure.h"

namespace desmo {

/// The structural group that solves for each point and vector of a mechanism; -1: it is on the
/// ground or on no body.
struct Placement {
  std::vector<int> of_point, of_vector;

  /// Returns the last group that solves for an entity of the coordinate's definition; -1: none.
  int of(const Mechanism::Coordinate& coordinate) const;
};

/// Assigns each point and vector to the first group with a body that carries it. There is one
/// exception: an entity may wait for a later group that alone has it in the basis of a body. No
/// driver, no coupling and no second body may need it before. may_wait: false to make no exception.
Placement place_entities(const Mechanism& mechanism, const RigidBodies& rigid,
                         const Structure& structure, bool may_wait = true);

}  // namespace desmo
