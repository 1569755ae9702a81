#pragma once

#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/model/model.h"
#include "formulations/modelling/bodies/rigid_bodies.h"
#include "formulations/modelling/groups/structure.h"

namespace desmo {

/// Natural and mixed coordinates of a description, and where its entities went.
struct Coordinates {
  Model model;                            ///< groups, entities and drivers; no constraints yet
  std::vector<EntityId> points, vectors;  ///< of the description's; -1: carried by no body
  /// Relative coordinates: those of the description, then the distances of its spatial sliding
  /// joints that it does not declare, `<joint>/distance`.
  std::vector<Mechanism::Coordinate> measured;
  std::vector<EntityId> coordinates;  ///< of those measured
};

/// Points of the ground are constants; a vector of the ground that moving bodies share is a
/// coordinate vector of a constant group, as the paper models it. Which group finds what:
/// place_entities; how groups are named: GroupNames. motions: one for each driven coordinate, in
/// order. Throws std::invalid_argument, naming the coordinate, for one that measures nothing that
/// can move.
Coordinates make_coordinates(const Mechanism& mechanism, const RigidBodies& rigid,
                             const Structure& structure, const std::vector<Motion>& motions);

}  // namespace desmo
