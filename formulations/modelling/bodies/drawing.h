#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/mechanism/drawing.h"
#include "cases/numbers/space.h"
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

// ---- Exact directions ----

/// Rounding of drawn directions of length 1. Components of equal directions differ by ≤ this; the
/// |cosine| of directions at a right angle is ≤ this.
inline constexpr double direction_tolerance = 1e-12;

/// Returns the vector a, scaled to length 1.
inline Mechanism::ExactVec unit_vector(const Mechanism::ExactVec& a) {
  const Derived length = sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

/// Returns the part of a that is at a right angle to the unit vector `of`.
inline Mechanism::ExactVec across(const Mechanism::ExactVec& a, const Mechanism::ExactVec& of) {
  const Derived along = dot(a, of);
  return {a[0] - along * of[0], a[1] - along * of[1], a[2] - along * of[2]};
}

/// Returns whether two directions of length 1 are the same, to direction_tolerance.
inline bool are_same(const Mechanism::ExactVec& a, const Mechanism::ExactVec& b) {
  return std::ranges::equal(a, b, [](const Derived& x, const Derived& y) {
    return std::abs((x - y).value) <= direction_tolerance;
  });
}

/// Returns whether two directions of length 1 are at a right angle, to direction_tolerance.
inline bool are_normal(const Mechanism::ExactVec& a, const Mechanism::ExactVec& b) {
  return std::abs(dot(a, b).value) <= direction_tolerance;
}

/// Writes an exact position or direction as the nearest doubles, and the remainders that these
/// lack.
inline void set_exact(Mechanism::Vec& nearest, std::array<Remainder, 3>& remainder,
                      const Mechanism::ExactVec& exact) {
  for (int i = 0; i < 3; ++i) {
    const Derived x = exact[i].rounded();
    nearest[i] = x.value;
    remainder[i] = x.remainder();
  }
}

}  // namespace desmo
