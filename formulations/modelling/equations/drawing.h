#pragma once

#include "cases/mechanism/drawing.h"
#include "formulations/constraints/vec.h"
#include "formulations/modelling/bodies/rigid_bodies.h"

namespace desmo {

/// A drawing with the dimensions that bodies state.
template <class S>
struct BodyDrawing : Drawing<S> {
  using typename Drawing<S>::Vec, typename Drawing<S>::Direction;
  using Drawing<S>::direction;

  /// Returns a vector of the length that a line has on a body: the stated one, along the first
  /// axis, or the line itself.
  Vec span(const RigidBody& body, const Direction& line) const {
    if (const auto stated = nominal::stated_length(body, line)) return {S(*stated), S(0), S(0)};
    return direction(line);
  }
  /// Returns a direction on a body; a line of stated length has that length.
  Vec direction(const RigidBody& body, const Direction& d) const {
    Vec u = direction(d);
    if (const auto stated = nominal::stated_length(body, d)) {
      const S scale = S(*stated) / vec::norm<3>(u.data());
      for (S& x : u) x = x * scale;
    }
    return u;
  }
};

}  // namespace desmo
