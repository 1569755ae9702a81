#pragma once

#include <array>
#include <optional>
#include <vector>

#include "formulations/modelling/coordinates/coordinates.h"
#include "formulations/modelling/frames/tree.h"

namespace desmo {

/// The frame of a rigid body and the tree joint from whose variables it is derived. Points, vectors
/// and coordinates are positions in FramedMechanism::mechanism.
struct DerivedFrame {
  int origin = Mechanism::none;                                                ///< point
  std::array<int, 3> axes{Mechanism::none, Mechanism::none, Mechanism::none};  ///< plane: one

  /// Directions of the parent between which the first angle of the joint turns, at right angles. In
  /// the plane the first alone; none: the x axis of the ground.
  int from = Mechanism::none, towards = Mechanism::none;
  bool opposite = false;  ///< the angle counts from −from

  /// Declared coordinates that are the joint's variables; none: these are internal.
  int angle = Mechanism::none, travel = Mechanism::none;
  /// Estimates of internal variables: angles [rad], travel.
  double first_angle = 0, second_angle = 0, start_travel = 0;
  std::array<double, 4> orientation{};  ///< Euler parameters in the frame of the parent
};

/// Two vectors of different bodies that a cut joint keeps at right angles.
struct NormalVectors {
  int vector, normal;
};
/// Points of a cut joint whose line is normal to a vector.
struct NormalLine {
  int joint, normal;
};

/// A mechanism with a frame on each rigid body that has one: its origin and axes stand after the
/// mechanism's own points and vectors, where none of these will do.
struct FramedMechanism {
  Mechanism mechanism;
  RigidBodies rigid;  ///< with bases of origins and axes
  SpanningTree tree;
  std::vector<DerivedFrame> frames;    ///< by rigid body
  std::vector<int> deriving;           ///< first rigid body in the tree that carries each point
  std::vector<int> deriving_vector;    ///< … and each vector
  std::vector<NormalVectors> vectors;  ///< closures of shared vectors
  std::vector<NormalLine> lines;       ///< closures of spatial sliding joints
};

/// Puts frames on the bodies of a mechanism:
/// - origin: a point of its own where the joint is free; else the joint's point; where that slides
///   and an earlier body derives it, a new point in its place
/// - axes: the axis of the joint, and what is normal to it; a vector of the file is taken where it
///   is the same within 1e-12
/// - a declared angle or travel that measures the tree joint is its variable
FramedMechanism put_frames(const Mechanism& mechanism, const RigidBodies& rigid,
                           const Structure& structure, Modelling modelling);

/// Gives bodies in space that lie nearly in a plane its normal as a third direction of their bases:
/// where no direction leads farther than 6° out of the plane of two others, but some point or
/// vector lies off it by more than rounding. A third direction of the body's own would make
/// equations that are nearly dependent, and without one the body would be flat. Returns the
/// mechanism with these vectors, and its rigid bodies (its other members mean nothing); nothing
/// where it needs none.
std::optional<FramedMechanism> with_plane_normals(const Mechanism& mechanism,
                                                  const RigidBodies& rigid);

class EquationWriter;

/// Writes from which variables the frame of a rigid body is derived, in D dimensions, and adds
/// those that no coordinate of the mechanism is.
template <int D>
void write_frame(EquationWriter& writer, int body);

/// Writes what cut joints demand of shared vectors and sliding points, in D dimensions.
template <int D>
void write_cut_joints(EquationWriter& writer);

}  // namespace desmo
