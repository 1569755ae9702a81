#pragma once

#include "cases/mechanism/drawing.h"
#include "formulations/modelling/bodies/rigid_bodies.h"

namespace desmo {

/// A drawing of a mechanism that also knows the own shapes of its bodies (RigidBody::has_shape).
template <class S>
struct BodyDrawing : Drawing<S> {
  using typename Drawing<S>::Vec, typename Drawing<S>::Direction;
  using Drawing<S>::direction;

  /// Returns a direction on a body, in the frame of its own shape; as drawn, when it has none.
  Vec direction(const RigidBody& body, const Direction& d) const {
    if (!body.has_shape()) return direction(d);
    if (!d.is_line()) return in_scalar(body.own_vectors.at(d.vector));
    const Vec from = in_scalar(body.own_points.at(d.from)),
              to = in_scalar(body.own_points.at(d.to));
    return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  }

 private:
  using Drawing<S>::in_scalar;
};

}  // namespace desmo
