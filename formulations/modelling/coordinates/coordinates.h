#pragma once

#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/model/model.h"
#include "formulations/modelling/bodies/rigid_bodies.h"
#include "formulations/modelling/groups/structure.h"

namespace desmo {

/// The coordinates of a mechanism: those of points and vectors, and relative ones.
struct Coordinates {
  Model model;                            ///< groups, entities and drivers; no constraints yet
  std::vector<EntityId> points, vectors;  ///< entity of each point and vector; -1: on no body
  /// Relative coordinates: those that the mechanism declares, then the undeclared distances of its
  /// spatial sliding joints, named `<joint>/distance`.
  std::vector<Mechanism::Coordinate> measured;
  std::vector<EntityId> coordinates;   ///< entity of each relative coordinate
  std::vector<GroupId> group_of_body;  ///< group of each rigid body; no_position: the ground
};

/// Returns whether a coordinate is the distance along a sliding joint, in either sense.
bool is_distance_of(const Mechanism::Joint& joint, const Mechanism::Coordinate& coordinate);

/// Returns whether the mechanism declares the distance along a sliding joint as a coordinate.
bool declares_distance(const Mechanism& mechanism, const Mechanism::Joint& joint);

/// Makes the coordinates of a mechanism. Ground points are constants. A ground vector that moving
/// bodies share is a coordinate vector of a constant group, as in the paper; others are constants.
/// place_entities() assigns entities to groups; where bodies have frames, always to the first group
/// that carries them. motions: one per driven coordinate, in order. Throws std::invalid_argument,
/// naming the coordinate, when a coordinate measures nothing that can move.
Coordinates make_coordinates(const Mechanism& mechanism, const RigidBodies& rigid,
                             const Structure& structure, const std::vector<Motion>& motions,
                             Modelling modelling);

}  // namespace desmo
