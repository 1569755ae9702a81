#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "formulations/modelling/bodies/drawing.h"
#include "formulations/modelling/frames/frames.h"

namespace desmo {

/// Rounding of drawn directions of length 1. Components of equal directions differ by ≤ this; the
/// |cosine| of directions at a right angle is ≤ this.
inline constexpr double same_direction = 1e-12;

/// A maker of the axes of bodies: finds vectors of a body by their directions, or adds them.
/// Directions are those of the body's shape (BodyDrawing).
class AxisMaker {
 public:
  using Exact = BodyDrawing<Derived>::Vec;

  /// framed: must outlive the maker, which changes its mechanism, bodies, `deriving` and
  /// `deriving_vector`.
  explicit AxisMaker(FramedMechanism& framed);

  /// Returns a direction of a rigid body in the frame of its own shape; as drawn, if it has none.
  Exact own(int body, const Mechanism::Direction& d) const;
  Exact own(int body, int vector) const { return own(body, Mechanism::Direction{vector}); }

  /// Returns three orthonormal directions of a body, the first along the first direction of its
  /// basis; for the ground, the axes of space.
  std::array<Exact, 3> own_axes(int body) const;

  /// Returns an axis of the body's frame, or a vector that the body derives, with this direction.
  /// Adds a vector, named `<body>/<what>` and numbered where that is taken, if there is none.
  int find_or_add_axis(int body, const Exact& direction, const char* what);

  /// Returns the indices of two normals of a body's `vector` u: n₁ and n₂ = u × n₁, both vectors of
  /// the body. Adds those that the body does not have.
  std::pair<int, int> find_or_add_normals(int body, int vector);

  /// Returns the direction of a body's basis that is most nearly normal to `axis`, scaled to
  /// length 1; the first one when others differ from it by rounding alone.
  Exact nearest_to_normal(int body, const Exact& axis) const;

  /// Returns whether an angle is the turn of a body's tree joint: it goes from directions that the
  /// parent carries to one that the body carries. In space all are normal to the vector `axis`.
  bool measures_turn(const Mechanism::Coordinate& angle, int parent, int body, int axis) const;

  /// Adds the normal of the first two directions of a body's basis, as a third one.
  void add_normal(int body);

  /// Adds a point to a body, in the place of another one.
  int add_point(int body, int place, const char* what);

 private:
  int add_vector(int body, const Exact& own, const char* what);
  Exact drawn(int body, const Exact& own) const;
  std::string unique_name(int body, const char* what);

  FramedMechanism& framed_;
  std::set<std::string> names_;
  std::map<std::pair<int, int>, std::pair<int, int>> normals_;  // normals made, by body and vector
};

/// Returns whether a rigid body carries a direction: a vector, or both points of a line.
bool carries(const RigidBodies& rigid, int body, const Mechanism::Direction& direction);

/// Adds the closures of cut joints to a mechanism with frames, and the normals that they need.
/// - orientation: by rigid body, the first body with the same axes
/// - own_vectors: number of vectors of the mechanism itself
void plan_cut_joints(FramedMechanism& framed, AxisMaker& axes, const std::vector<int>& orientation,
                     int own_vectors);

/// Returns the names of all points, vectors and coordinates.
std::set<std::string> names_in(const Mechanism& mechanism);

/// Writes an exact position or direction as the nearest doubles, and the remainders that these
/// lack.
void set_exact(Mechanism::Vec& nearest, std::array<Remainder, 3>& remainder,
               const AxisMaker::Exact& exact);

/// Returns the vector a, scaled to length 1.
AxisMaker::Exact unit(const AxisMaker::Exact& a);
/// Returns the part of a that is at a right angle to the unit vector `of`.
AxisMaker::Exact across(const AxisMaker::Exact& a, const AxisMaker::Exact& of);
/// Returns whether two directions of length 1 are the same, to same_direction.
bool are_same(const AxisMaker::Exact& a, const AxisMaker::Exact& b);
/// Returns whether two directions of length 1 are at a right angle, to same_direction.
bool are_normal(const AxisMaker::Exact& a, const AxisMaker::Exact& b);

}  // namespace desmo
