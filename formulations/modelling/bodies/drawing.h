#pragma once

#include <array>

#include "cases/mechanism/drawing.h"
#include "formulations/modelling/bodies/rigid_bodies.h"

namespace desmo {

/// A drawing with the shapes that bodies have of their own.
template <class S>
struct BodyDrawing : Drawing<S> {
  using typename Drawing<S>::Vec, typename Drawing<S>::Direction;
  using Drawing<S>::direction;

  /// Returns a direction on a body, in the frame of its shape.
  Vec direction(const RigidBody& body, const Direction& d) const {
    if (!body.has_shape()) return direction(d);
    if (!d.is_line()) return rounded(body.own_vectors.at(d.vector));
    const Vec from = rounded(body.own_points.at(d.from)), to = rounded(body.own_points.at(d.to));
    return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  }

 private:
  static Vec rounded(const std::array<Derived, 3>& x) {
    return {as<S>(x[0]), as<S>(x[1]), as<S>(x[2])};
  }
};

}  // namespace desmo
