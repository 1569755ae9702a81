#pragma once

#include <algorithm>

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
    if (!d.is_line()) return in_shape(body.own_vectors, body.vectors, d.vector);
    const Vec from = in_shape(body.own_points, body.points, d.from),
              to = in_shape(body.own_points, body.points, d.to);
    return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  }

 private:
  static Vec in_shape(const std::vector<std::array<Derived, 3>>& own,
                      const std::vector<int>& listed, int entity) {
    const auto& [x, y, z] = own[std::ranges::find(listed, entity) - listed.begin()];
    return {as<S>(x), as<S>(y), as<S>(z)};
  }
};

}  // namespace desmo
