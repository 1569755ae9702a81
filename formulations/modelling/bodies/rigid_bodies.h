#pragma once

#include <map>
#include <vector>

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// The basis of a rigid body: a point and up to three independent directions (one in the plane).
/// Each direction is a vector, or the line from that point to another. All other points and
/// vectors of the body are linear functions of the basis. Nearly flat bodies are an exception until
/// with_plane_normals() completes their bases.
struct Basis {
  int origin = -1;                               ///< its point; -1: the body carries none
  std::vector<Mechanism::Direction> directions;  ///< vectors first, then lines from the origin

  bool has_point(int point) const;
  bool has_vector(int vector) const;
};

/// A set of one or more bodies that fixed joints connect.
struct RigidBody {
  std::vector<int> bodies;           ///< bodies of the mechanism, ascending
  std::vector<int> points, vectors;  ///< distinct points and vectors on any of these bodies
  Basis basis;                       ///< empty for the ground
  /// 3 in the plane or 6 in space, less motions that move no point or vector (a rod's spin); 0 for
  /// the ground.
  int freedoms = 0;

  /// Points and vectors in a frame of the body's own, when its drawing is an estimate; else empty.
  std::map<int, Mechanism::ExactVec> own_points, own_vectors;
  bool has_shape() const { return !own_points.empty() || !own_vectors.empty(); }
};

/// The rigid bodies of a mechanism, in the order of their first body.
struct RigidBodies {
  std::vector<RigidBody> list;                        ///< the first contains the ground
  std::vector<int> of_body;                           ///< rigid body of each mechanism's body
  std::vector<std::vector<int>> of_point, of_vector;  ///< rigid bodies that carry each, ascending

  /// Returns whether a joint connects a rigid body with another one.
  bool is_joint_of(int body, const Mechanism::Joint& joint) const {
    return (of_body[joint.bodies[0]] == body) != (of_body[joint.bodies[1]] == body);
  }
};

/// Returns whether a vector is declared along two points of this body and so follows from them. No
/// vector of a body with a frame of its own does.
bool follows_from_points(const Mechanism& mechanism, const RigidBody& body, int vector);

/// Throws std::invalid_argument, naming the body, when a length on a body is < 1e-152 or > 1e152.
/// Lengths are the stated one and distances from the body's first point; equations contain their
/// squares. Lengths of 0 and infinite ones pass.
void require_representable(const Mechanism& mechanism);

/// Merges bodies that fixed joints connect, and chooses their bases. Vectors that do not follow
/// from points are taken first, in the bodies' order. Then come lines from the body's first point.
/// A second direction at less than 5.7° to the first is taken only as a last resort. A third one at
/// less than 5.7° to the plane of two others is never taken. Throws std::invalid_argument, naming
/// the body, when
/// - a body carries neither point nor vector,
/// - a declared length is not the nominal one, although a fixed joint adds points to the body or
///   holds it on the ground,
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
