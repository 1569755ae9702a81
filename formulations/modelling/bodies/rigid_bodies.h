#pragma once

#include <map>
#include <vector>

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// The basis of a rigid body: a point and up to three independent directions (one in the plane).
/// Each direction is a vector, or the line from that point to another. All other points and
/// vectors of the body are linear functions of the basis.
struct Basis {
  int origin = -1;                               ///< point; -1: the body carries none
  std::vector<Mechanism::Direction> directions;  ///< vectors first, then lines

  bool has_point(int point) const;
  bool has_vector(int vector) const;
};

/// A set of one or more bodies that fixed joints connect.
struct RigidBody {
  std::vector<int> bodies;           ///< bodies of the mechanism, ascending
  std::vector<int> points, vectors;  ///< points and vectors on any of these, each once
  Basis basis;
  int freedoms = 0;  ///< 3 or 6, less motions that move no point or vector (a rod's spin)

  /// Points and vectors in a frame of its own, where its drawing is an estimate; else empty.
  std::map<int, Mechanism::ExactVec> own_points, own_vectors;
  bool has_shape() const { return !own_points.empty() || !own_vectors.empty(); }
};

/// The rigid bodies of a mechanism, in the order of their first body.
struct RigidBodies {
  std::vector<RigidBody> list;                        ///< the first contains the ground
  std::vector<int> of_body;                           ///< rigid body of each body
  std::vector<std::vector<int>> of_point, of_vector;  ///< rigid bodies that carry it, ascending

  /// Returns whether a joint connects a rigid body with another one.
  bool is_joint_of(int body, const Mechanism::Joint& joint) const {
    return (of_body[joint.bodies[0]] == body) != (of_body[joint.bodies[1]] == body);
  }
};

/// Returns whether a vector is declared along two points of this body and so follows from them. No
/// vector of a body with a frame of its own does.
bool follows_from_points(const Mechanism& mechanism, const RigidBody& body, int vector);

/// Throws std::invalid_argument, naming the body, when the square of a length on a body over- or
/// underflows in double precision. Equations contain such squares.
void require_representable(const Mechanism& mechanism);

/// Merges fixed bodies and chooses their bases. Vectors that do not follow from points are taken
/// first, in the mechanism's order, then lines from the body's first point. A second direction
/// within 6° of the first is taken only as a last resort, a third one within 6° of the plane of two
/// others never. Throws std::invalid_argument, naming the body, when
/// - a body carries neither point nor vector,
/// - a declared length is not the nominal one, although a fixed joint adds points to the body,
/// - a body with a frame of its own is drawn as in a mirror, unless it is nearly flat.
RigidBodies find_rigid_bodies(const Mechanism& mechanism);

/// Geometry of a mechanism in its nominal position.
namespace nominal {

using Vec = Mechanism::Vec;

Vec operator-(const Vec& a, const Vec& b);
double norm(const Vec& a);
/// Returns the largest distance of a point from the first one; 1 for a mechanism without extent.
double extent(const Mechanism& mechanism);

}  // namespace nominal

}  // namespace desmo
