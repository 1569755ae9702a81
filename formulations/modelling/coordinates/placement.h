#pragma once

#include <vector>

#include "formulations/modelling/bodies/rigid_bodies.h"
#include "formulations/modelling/groups/structure.h"

namespace desmo {

/// The structural group that finds each entity of a description; -1: the ground carries it, or
/// nothing does.
struct Placement {
  std::vector<int> of_point, of_vector;

  /// The last group that finds something a coordinate is measured from; -1: none does.
  int of(const Mechanism::Coordinate& coordinate) const;
};

/// An entity is found by the first group in which it is in the basis of a body; one that follows
/// from an earlier body by a linear relation, by the only later group that builds on it, if nothing
/// needs it before.
Placement place_entities(const Mechanism& mechanism, const RigidBodies& rigid,
                         const Structure& structure);

}  // namespace desmo
