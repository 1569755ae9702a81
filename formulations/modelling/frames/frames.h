#pragma once

#include <array>
#include <optional>
#include <vector>

#include "formulations/modelling/coordinates/coordinates.h"
#include "formulations/modelling/frames/tree.h"

namespace desmo {

/// The frame of a rigid body, and the variables of the tree joint that it is derived from. Points,
/// vectors and coordinates are indices in FramedMechanism::mechanism.
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
  /// Estimates of internal variables: angles [rad], travel [unit of length].
  double first_angle = 0, second_angle = 0, start_travel = 0;
  std::array<double, 4> orientation{};  ///< Euler parameters in the frame of the parent
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

class EquationWriter;

/// Writes the equations that derive a rigid body's frame from the variables of its tree joint, in D
/// dimensions. Adds those variables that are no declared coordinates.
template <int D>
void write_frame(EquationWriter& writer, int body);

/// Writes the closures of shared vectors and of spatial sliding joints, in D dimensions.
template <int D>
void write_cut_joints(EquationWriter& writer);

}  // namespace desmo
