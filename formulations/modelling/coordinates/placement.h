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
/// exception: an entity waits for a later group where no other group has it in the basis of a body.
/// No equation of an earlier group may need the entity: no driver, no coupling, no joint and no
/// vector along points. Up to that group only one body may follow from it. may_wait: false to make
/// no exception.
Placement place_entities(const Mechanism& mechanism, const RigidBodies& rigid,
                         const Structure& structure, bool may_wait);

}  // namespace desmo
