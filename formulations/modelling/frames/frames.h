#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "formulations/base/settings.h"
#include "formulations/modelling/bodies/drawing.h"
#include "formulations/modelling/bodies/rigid_bodies.h"
#include "formulations/modelling/groups/structure.h"

namespace desmo {

/// Ways in which the axes of a body follow from those of its parent.
enum class Turn {
  none,            ///< they are the parent's
  in_plane,        ///< turned by an angle in the plane
  about_axis,      ///< turned by an angle about a vector that both bodies carry
  about_two_axes,  ///< turned about a vector of the parent, then about one of the body
  freely,          ///< turned by Euler parameters
};

/// The place of a rigid body in the spanning tree.
struct TreeJoint {
  int parent = 0;               ///< rigid body that it hangs on; 0: the ground
  int joint = Mechanism::none;  ///< joint of the mechanism; none: a free joint
  bool is_first = false;        ///< the body is the first of the joint
  Turn turn = Turn::none;
};

/// A spanning tree of the rigid bodies that have a frame. In `relative` coordinates a body hangs on
/// its parent by a joint of the mechanism. Where none is suitable, it hangs on the ground by a free
/// joint. In `reference` coordinates all bodies do.
struct SpanningTree {
  std::vector<int> order;  ///< all rigid bodies but the ground: parents first, group by group
  std::vector<TreeJoint> hanging;  ///< tree joint of each rigid body
  std::vector<bool> has_frame;     ///< rigid bodies that have a frame; the ground is one
  std::vector<bool> is_of_tree;    ///< joints that are in the tree; all others are cut
};

/// Returns the tree, group by group in solution order. In `relative` coordinates the next body of a
/// group hangs on a placed one by the joint of the fewest variables that a tree may have. Among
/// equals the body with the most joints goes first. Then the parent nearest to earlier groups
/// decides, then the order of the joints. All other bodies hang on the ground by a free joint. A
/// body that can spin idly, such as a rod between two spherical joints, has no frame.
SpanningTree make_tree(const Mechanism& mechanism, const RigidBodies& rigid,
                       const Structure& structure, Modelling modelling);

/// The frame of a rigid body, and what it is derived from. Points, vectors and coordinates are
/// indices in FramedMechanism::mechanism.
struct DerivedFrame {
  int origin = Mechanism::none;  ///< point that is the origin
  /// Vectors that are the x, y and z axes; in the plane only x.
  std::array<int, 3> axes{Mechanism::none, Mechanism::none, Mechanism::none};

  /// Vectors of the parent at right angles. The first angle of the joint counts from `from` towards
  /// `towards`. In the plane there is only `from`; none: the x axis of the ground.
  int from = Mechanism::none, towards = Mechanism::none;
  bool opposite = false;  ///< the angle counts from −from

  /// Declared coordinates that are the joint's variables; none: these are internal.
  int angle = Mechanism::none, travel = Mechanism::none;
};

/// Two vectors of different bodies that a cut joint keeps at right angles.
struct NormalVectors {
  int vector, normal;
};
/// A cut joint, with a vector that the line between its points is normal to.
struct NormalLine {
  int joint, normal;
};

/// A mechanism with frames on its rigid bodies. Origins and axes that are no points and vectors of
/// the original mechanism are added after these.
struct FramedMechanism {
  Mechanism mechanism;
  RigidBodies rigid;  ///< a body with a frame has it as basis: origin and axes
  SpanningTree tree;
  std::vector<DerivedFrame> frames;    ///< frame of each rigid body
  std::vector<int> deriving;           ///< first rigid body in the tree that carries each point
  std::vector<int> deriving_vector;    ///< first rigid body in the tree that carries each vector
  std::vector<NormalVectors> vectors;  ///< closures of shared vectors
  std::vector<NormalLine> lines;       ///< closures of spatial sliding joints
};

/// Puts frames on the bodies of a mechanism:
/// - origin: a point of its own where the joint is free; else the joint's point; where that slides
///   and an earlier body derives it, a new point in its place
/// - axes: those of the parent at a prismatic joint; else, in space, the axis of the joint if it
///   has one, and normals of it. A vector of the file is taken where it is the same within 1e-12
/// - a declared angle or travel that measures the tree joint is its variable
FramedMechanism put_frames(const Mechanism& mechanism, const RigidBodies& rigid,
                           const Structure& structure, Modelling modelling);

/// Gives nearly flat bodies in space the normal of their plane as a third direction of their bases.
/// No direction of such a body leads more than 5.7° out of the plane of two others. But some point
/// or vector lies off that plane by more than rounding. A third direction of the body's own would
/// make nearly dependent equations; without one the body would be flat. Returns the mechanism with
/// these vectors, and its rigid bodies (other members mean nothing); nullopt where no body needs
/// one.
std::optional<FramedMechanism> with_plane_normals(const Mechanism& mechanism,
                                                  const RigidBodies& rigid);

/// A maker of the axes of bodies: finds vectors of a body by their directions, or adds them.
/// Directions are those of the body's shape (BodyDrawing).
class AxisMaker {
 public:
  using Exact = Mechanism::ExactVec;

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
};

/// Returns the names of all points, vectors and coordinates.
std::set<std::string> names_in(const Mechanism& mechanism);

/// Adds a name to those that are taken: `base`, numbered if need be. Returns it.
std::string add_name(std::set<std::string>& names, const std::string& base);

/// Adds the closures of cut joints to a mechanism whose bodies have their frames, and the normals
/// that they need.
void plan_cut_joints(FramedMechanism& framed, AxisMaker& axes);

class EquationWriter;

/// Writes the equations that derive a rigid body's frame from the variables of its tree joint. Adds
/// those variables that are no declared coordinates.
void write_frame(EquationWriter& writer, int body);

/// Writes the closures of shared vectors and of spatial sliding joints.
void write_cut_joints(EquationWriter& writer);

}  // namespace desmo
