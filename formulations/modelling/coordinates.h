#pragma once

#include <set>
#include <vector>

#include "cases/mechanism.h"
#include "cases/motion.h"
#include "formulations/modelling/rigid_bodies.h"
#include "formulations/modelling/structure.h"

namespace desmo {

/// Natural and mixed coordinates of a description, and where its entities went.
struct Coordinates {
  Mechanism mechanism;                    ///< groups, entities and drivers; no constraints yet
  std::vector<EntityId> points, vectors;  ///< of the description's; -1: carried by no body
  /// Relative coordinates: those of the description, then the distances of its spatial sliding
  /// joints that it does not declare, `<joint>/distance`.
  std::vector<Description::Coordinate> measured;
  std::vector<EntityId> coordinates;  ///< of those measured
};

/// The distances along sliding joints that a description declares.
class DeclaredSlides {
 public:
  explicit DeclaredSlides(const Description& description);
  /// Whether a joint slides, so that a distance along it can define it.
  static bool slides(const Description::Joint& joint);
  /// Whether its distance is declared.
  bool contain(const Description::Joint& joint) const;

 private:
  std::set<std::array<int, 3>> declared_;  // vector, and the points in ascending order
};

/// Points of the ground are constants; a vector of the ground that moving bodies share is a
/// coordinate vector of a constant group, as the paper models it. An entity is found by the first
/// group in which it is in the basis of a body; one that follows from an earlier body by a linear
/// relation, by the only later group that builds on it, if nothing needs it before. Groups are
/// named as in the paper, SG-I, SG-II, …, after what the names of their bodies have in common up to
/// a "/". motions: one for each driven coordinate, in order. Throws std::invalid_argument, naming
/// the coordinate, for one that measures nothing that can move.
Coordinates make_coordinates(const Description& description, const RigidBodies& rigid,
                             const Structure& structure, const std::vector<Motion>& motions);

}  // namespace desmo
