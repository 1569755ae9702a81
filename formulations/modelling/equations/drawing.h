#pragma once

#include <array>
#include <type_traits>

#include "cases/numbers/derived.h"
#include "formulations/constraints/vec.h"
#include "formulations/modelling/bodies/rigid_bodies.h"

namespace desmo {

/// The nominal positions of a mechanism as the file means them, in a scalar S: double, in which
/// dimensions are rounded, or Derived.
template <class S>
struct Drawing {
  using Vec = std::array<S, 3>;
  using Direction = Mechanism::Direction;

  const Mechanism& mechanism;

  static Vec origin() { return {}; }
  Vec point(int p) const {
    const Mechanism::Vec& x = mechanism.points[p].position;
    return {S(x[0]), S(x[1]), S(x[2])};
  }
  Vec vector(int v) const {
    const Mechanism::Vector& u = mechanism.vectors[v];
    const auto component = [&](int i) -> S {
      if constexpr (std::is_same_v<S, double>)
        return u.direction[i];
      else
        return {u.direction[i], u.remainder[i]};
    };
    return {component(0), component(1), component(2)};
  }
  Vec direction(const Direction& d) const {
    return d.is_line() ? vec::difference<3>(point(d.from).data(), point(d.to).data())
                       : vector(d.vector);
  }

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
