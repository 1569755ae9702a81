// Directions and frames of bodies as functions of time, for measures.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "cases/mechanism/level.h"
#include "formulations/base/observer.h"
#include "formulations/constraints/jet.h"
#include "formulations/model/model.h"
#include "formulations/model/plan.h"
#include "formulations/modelling/bodies/rigid_bodies.h"

namespace desmo::frames {

using Number = Jet<double>;
using Vector = std::array<Number, 3>;
using Frame = std::array<Vector, 3>;  ///< three orthonormal axes

inline const Frame ground{{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};

/// Returns a vector of constant length, scaled to length 1.
Vector unit(const Vector& a);

/// Returns the axes of `frame` in components along the axes of `other`.
Frame seen_from(const Frame& other, const Frame& frame);

/// A point or vector as a function of the instant; either coordinates or a fixed value.
struct Operand {
  Vector fixed{};
  int first = 0, size = 0;  ///< first coordinate and number of them; 0: it is fixed
  Level level;              ///< highest level that is read

  Vector operator()(const Instant& instant) const;
};

/// A vector, whose `from` is zero, or the line from one point to another.
struct Line {
  Operand to, from;

  Vector operator()(const Instant& instant) const;
};

/// The frame of a rigid body.
struct BodyFrame {
  Frame drawn = ground;       ///< the frame as drawn (BodyFrames::drawn)
  std::vector<Line> lines{};  ///< directions: one in the plane, two in space; none: the ground

  Frame operator()(const Instant& instant) const;
};

/// A finder of directions and frames of a mechanism's bodies in its model.
class BodyFrames {
 public:
  /// inputs: what the directions and frames read is added to it.
  BodyFrames(const Mechanism& mechanism, const Model& m, std::vector<Output>& inputs)
      : mechanism_(mechanism), m_(m), inputs_(inputs), rigid_(find_rigid_bodies(mechanism)) {}

  Line find_line(const Mechanism::Direction& direction);
  /// Returns whether a body's points and vectors tell how it is turned.
  bool tells_turn(int body) const;
  /// Returns the frame of a body. Throws std::invalid_argument, naming the body, when its points
  /// and vectors do not tell how it is turned.
  BodyFrame find_frame(int body);
  /// Returns the rotation by which a body's own frame is drawn; the identity when it has none.
  Eigen::Matrix3d turn_of_frame(int body) const;
  /// Returns a direction of a body as drawn. When the body has its own frame (Body::own), returns
  /// the direction in that frame, turned as the frame is drawn.
  Vector drawn(int body, const Mechanism::Direction& direction) const;

  Level level = Level::position;  ///< highest level read of operands that are found from now on

 private:
  Operand find_operand(const std::string& name);
  /// Returns how many directions tell how a body is turned.
  std::size_t directions_needed() const { return mechanism_.dimension == 2 ? 1 : 2; }

  const Mechanism& mechanism_;
  const Model& m_;
  std::vector<Output>& inputs_;
  const RigidBodies rigid_;
};

}  // namespace desmo::frames
