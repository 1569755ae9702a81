#pragma once

#include <string>
#include <vector>

#include "formulations/modelling/bodies/rigid_bodies.h"
#include "formulations/modelling/modelling.h"

namespace desmo {

/// A structural group: a smallest set of bodies that are determined together, once earlier groups
/// are solved.
struct StructuralGroup {
  std::vector<int> bodies;  ///< positions in RigidBodies::list, ascending
  std::vector<int> after;   ///< earlier groups that it is joined to, ascending
  int freedoms = 0;         ///< freedoms of its bodies
  /// Freedoms that its joints, drivers and couplings remove, including redundant restrictions.
  int restrictions = 0;
};

/// The structural groups of a mechanism.
struct Structure {
  std::vector<StructuralGroup> groups;  ///< in solution order, then by first body
  std::vector<int> of_body;             ///< group of each rigid body; -1: the ground
};

/// The effect of a joint, a driver or a coupling on the freedoms of bodies.
struct Restriction {
  std::vector<int> bodies;  ///< rigid bodies that it connects, without the ground, ascending
  int count;                ///< number of freedoms that it removes
};

/// Returns the restrictions of all joints between different rigid bodies, then those of the
/// drivers, then those of the couplings. Throws std::invalid_argument, naming the driver or the
/// coupling, when one measures nothing that can move.
std::vector<Restriction> find_restrictions(const Mechanism& mechanism, const RigidBodies& rigid);

/// Returns the rigid bodies, without the ground, whose relative position a coordinate measures,
/// ascending. When several bodies carry a point, the first counts; of a line, the first that
/// carries both ends; for a distance along a vector, the first that also carries the vector.
std::vector<int> bodies_related(const RigidBodies& rigid, const Mechanism::Coordinate& coordinate);

/// Finds the structural groups of a mechanism: strong components of a maximum matching between
/// freedoms of bodies and restrictions (Dulmage & Mendelsohn 1958; paper, eq. 1). Over-constrained
/// bodies that are connected form one group; the structure does not show whether their surplus
/// restrictions are consistent. Throws std::invalid_argument
/// - when nothing determines some bodies (a driver is missing), naming these and a coordinate,
/// - when no body moves, and
/// - what find_restrictions() throws.
Structure find_structure(const Mechanism& mechanism, const RigidBodies& rigid);

/// Returns the idle freedoms of spatial bodies, in the order of the bodies. A body with a point has
/// one when all that it carries lies along one line or in that point. (A joint that prevents the
/// spin gives the body a vector across the line.)
std::vector<IdleFreedom> find_idle_freedoms(const Mechanism& mechanism, const RigidBodies& rigid);

/// Returns the axis about which an under-constrained spatial body can spin, if its only joints are
/// spherical and have two centres; otherwise an empty string.
std::string undetermined_spin(const Mechanism& mechanism, const RigidBodies& rigid, int body);

}  // namespace desmo
