#pragma once

#include <vector>

#include "formulations/modelling/bodies/rigid_bodies.h"

namespace desmo {

/// Rigid bodies that one joint or driver concerns, the ground left out, ascending, and the freedoms
/// that it removes.
struct Restriction {
  std::vector<int> bodies;
  int count;
};

/// Those of all joints between different rigid bodies, then those of the drivers. Throws
/// std::invalid_argument, naming the driver, for one that measures nothing that can move.
std::vector<Restriction> find_restrictions(const Mechanism& mechanism, const RigidBodies& rigid);

/// The rigid bodies, ground left out, whose relative position a coordinate measures, ascending.
/// Of several bodies that carry a point it is the first; for a distance along a vector, the first
/// that carries the vector too.
std::vector<int> bodies_related(const RigidBodies& rigid, const Mechanism::Coordinate& coordinate);

}  // namespace desmo
