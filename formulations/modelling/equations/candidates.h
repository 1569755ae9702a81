#pragma once

#include <vector>

#include "formulations/modelling/coordinates/coordinates.h"

namespace desmo {

/// Where a candidate equation comes from, in the order in which, other things being equal, one is
/// preferred to another.
enum class Origin { ground, coordinate, joint, body };

/// A mechanism with all the constraint equations that its description gives rise to; some may
/// depend on others.
struct Candidates {
  Model model;                  ///< constraints in group order
  std::vector<Origin> origins;  ///< of each constraint
};

/// Coordinates (see make_coordinates) and candidate equations (García de Jalón & Bayo, 1994):
/// - within a body: constant products of its basis, linear relations for all else;
/// - joints: shared points and vectors need no equation; an angle between vectors, an offset from
///   a line;
/// - relative coordinates: their definitions; they also define the joints along which they slide;
/// - ground vectors that are coordinates: held by linear equations.
/// An equation belongs to the last of the groups that find its coordinates.
/// motions: one for each driven coordinate, in order. Throws std::invalid_argument, naming the
/// coordinate, for one that cannot be modelled.
Candidates make_candidates(const Mechanism& mechanism, const RigidBodies& rigid,
                           const Structure& structure, const std::vector<Motion>& motions);

}  // namespace desmo
