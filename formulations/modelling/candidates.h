#pragma once

#include <vector>

#include "cases/mechanism.h"
#include "cases/motion.h"
#include "formulations/modelling/rigid_bodies.h"
#include "formulations/modelling/structure.h"

namespace desmo {

/// Where a candidate equation comes from, in the order in which, other things being equal, one is
/// preferred to another.
enum class Origin { ground, coordinate, joint, body };

/// A mechanism with all the constraint equations that its description gives rise to; some may
/// depend on others.
struct Candidates {
  Mechanism mechanism;          ///< constraints in group order
  std::vector<Origin> origins;  ///< of each constraint
};

/// Natural and mixed coordinates and candidate equations (García de Jalón & Bayo, 1994):
/// - points of the ground are constants; a vector of the ground that moving bodies share is a
///   coordinate vector, held by linear equations and solved once, as the paper models it;
/// - an entity is found by the first group in which it is in the basis of a body; one that follows
///   from a body by a linear relation, by the only later group that builds on it, if there is one;
/// - within a body: constant products of its basis, linear relations for all else;
/// - joints: shared points and vectors need no equation; an angle between vectors, an offset from
///   a line; a spatial prismatic or cylindrical joint has a distance coordinate, `<joint>/distance`
///   unless the description declares it;
/// - relative coordinates: their definitions.
/// An equation belongs to the last of the groups that find its coordinates.
/// motions: one for each driven coordinate, in order. Throws std::invalid_argument, naming the
/// coordinate, for one that cannot be modelled.
Candidates make_candidates(const Description& description, const RigidBodies& rigid,
                           const Structure& structure, const std::vector<Motion>& motions);

}  // namespace desmo
