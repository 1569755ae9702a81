// Directions and frames of bodies as functions of time, for measures.
#pragma once

#include <array>
#include <vector>

#include "cases/mechanism/level.h"
#include "formulations/base/observer.h"
#include "formulations/constraints/jet.h"

namespace desmo::frames {

using Number = Jet<double>;
using Vector = std::array<Number, 3>;
using Frame = std::array<Vector, 3>;  ///< orthonormal axes

inline const Frame ground{{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};

/// Returns the scalar product of two vectors.
Number dot(const Vector& a, const Vector& b);

/// Returns a vector of constant length, scaled to length 1.
Vector unit(const Vector& a);

/// Returns a frame from directions of a body: their lengths and the angle between them are
/// constant.
Frame frame_of(const Vector& u, const Vector& v);
/// Returns a frame in the plane from a direction of a body.
Frame frame_of(const Vector& u);

/// Returns the axes of a frame as those of another see them.
Frame seen_from(const Frame& other, const Frame& frame);

/// A point or vector, in the coordinates or fixed.
struct Operand {
  Vector fixed{};
  int first = 0, size = 0;  ///< of coordinates; none: it is fixed
  Level level;              ///< that is solved

  Vector operator()(const Instant& instant) const;
};

/// A vector, or the line from one point to another.
struct Line {
  Operand to, from;
  bool is_line;

  Vector operator()(const Instant& instant) const;
};

/// The frame of a rigid body.
struct BodyFrame {
  Frame drawn = ground;
  std::vector<Line> lines{};  ///< one in the plane, two in space; none: the ground

  Frame operator()(const Instant& instant) const;
};

}  // namespace desmo::frames
