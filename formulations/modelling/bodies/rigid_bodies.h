#pragma once

#include <string>
#include <vector>

#include "cases/mechanism/mechanism.h"
#include "formulations/modelling/coordinates/nominal.h"

namespace desmo {

/// What the coordinates of a rigid body are built on: a point and up to three independent
/// directions (one in the plane), each a vector or the segment from that point to another.
/// Everything else on the body is a linear function of them.
struct Basis {
  int origin = -1;  ///< point; -1: the body carries none
  std::vector<Mechanism::Direction> directions;

  bool has_point(int point) const;
  bool has_vector(int vector) const;
};

/// Bodies that fixed joints make one.
struct RigidBody {
  std::vector<int> bodies;           ///< of the description, ascending
  std::vector<int> points, vectors;  ///< carried by any of them, each once
  Basis basis;
  int freedoms = 0;  ///< 3 or 6, less what its points and vectors cannot tell (a rod's spin)

  /// A distance that a body of the description gives for its two points.
  struct GivenLength {
    int a, b;  ///< points
    double length;
  };
  std::vector<GivenLength> lengths;
};

/// The rigid bodies of a description, by their first body; the first contains the ground.
struct RigidBodies {
  std::vector<RigidBody> list;
  std::vector<int> of_body;                           ///< of each body of the description
  std::vector<std::vector<int>> of_point, of_vector;  ///< those that carry it, ascending
};

/// Whether a vector is defined along two points of this body, and so follows from them.
bool follows_from_points(const Mechanism& mechanism, const RigidBody& body, int vector);

/// Merges bodies and chooses bases: vectors first, in the order of the description, those that
/// follow from points left out; then segments from the first point; what is within 6 degrees of the
/// span of those before only at the end, where nothing better is left. Throws
/// std::invalid_argument, naming the body, when one carries nothing.
RigidBodies find_rigid_bodies(const Mechanism& mechanism);

namespace nominal {

/// The same on a rigid body: a segment has the length that the body gives for its points, if it
/// does.
Vec direction(const Mechanism& mechanism, const RigidBody& body, const Mechanism::Direction& d);

}  // namespace nominal

}  // namespace desmo
