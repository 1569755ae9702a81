#pragma once

#include <vector>

#include "formulations/modelling/bodies/rigid_bodies.h"

namespace desmo {

/// The effect of a joint or driver on the freedoms of bodies.
struct Restriction {
  std::vector<int> bodies;  ///< rigid bodies that it connects, without the ground, ascending
  int count;                ///< number of freedoms that it removes
};

/// Returns the restrictions of all joints between different rigid bodies, then those of the
/// drivers. Throws std::invalid_argument, naming the driver, when a driver measures nothing that
/// can move.
std::vector<Restriction> find_restrictions(const Mechanism& mechanism, const RigidBodies& rigid);

/// Returns the rigid bodies, without the ground, whose relative position a coordinate measures,
/// ascending. When several bodies carry a point, the first counts; for a distance along a vector,
/// the first that also carries the vector.
std::vector<int> bodies_related(const RigidBodies& rigid, const Mechanism::Coordinate& coordinate);

}  // namespace desmo
