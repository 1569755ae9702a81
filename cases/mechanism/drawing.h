#pragma once

#include <array>
#include <cmath>

#include "cases/mechanism/mechanism.h"
#include "cases/numbers/derived.h"
#include "cases/numbers/space.h"

namespace desmo {

/// The nominal positions of a mechanism in a scalar S: rounded (double), or with their remainders,
/// as the file means them (Derived).
template <class S>
struct Drawing {
  using Vec = std::array<S, 3>;
  using Direction = Mechanism::Direction;

  const Mechanism& mechanism;

  static Vec origin() { return {}; }
  Vec point(int p) const { return in_scalar(mechanism.points[p].exact()); }
  Vec vector(int v) const { return in_scalar(mechanism.vectors[v].exact()); }
  /// Returns the direction: a vector of length 1, or, of a line, its second point minus its first.
  Vec direction(const Direction& d) const {
    if (!d.is_line()) return vector(d.vector);
    const Vec from = point(d.from), to = point(d.to);
    return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  }

  /// Returns the value of a relative coordinate: an angle in [−π, π] [rad]; a distance, ≥ 0; of the
  /// types `along` and `component` a length with its sign.
  S value(const Mechanism::Coordinate& c) const {
    using enum Mechanism::CoordinateType;
    using std::atan2;
    using std::sqrt;
    if (c.type == component) return point(c.point)[c.axis];
    const Vec w = direction(c.of);
    if (c.type == distance) return sqrt(dot(w, w));
    if (c.type == along) return dot(w, vector(c.vector));
    if (mechanism.dimension == 3) {
      const S cosine = dot(w, direction(c.from));
      return atan2(dot(w, direction(c.towards)), c.opposite ? -cosine : cosine);
    }
    const Vec x = c.from.is_given() ? direction(c.from) : Vec{S(1), S(0), S(0)};
    return atan2(x[0] * w[1] - x[1] * w[0], dot(x, w));
  }

 protected:
  static Vec in_scalar(const Mechanism::ExactVec& x) {
    return {as<S>(x[0]), as<S>(x[1]), as<S>(x[2])};
  }
};

}  // namespace desmo
