#pragma once

#include <array>
#include <cstddef>

#include "tests/library/jet.h"

namespace desmo::exact {

template <std::size_t D>
struct Vec : std::array<Jet, D> {};

using Vec2 = Vec<2>;
using Vec3 = Vec<3>;

template <std::size_t D>
Vec<D> operator+(const Vec<D>& a, const Vec<D>& b) {
  Vec<D> c;
  for (std::size_t i = 0; i < D; ++i) c[i] = a[i] + b[i];
  return c;
}
template <std::size_t D>
Vec<D> operator*(Jet s, const Vec<D>& a) {
  Vec<D> c;
  for (std::size_t i = 0; i < D; ++i) c[i] = s * a[i];
  return c;
}
template <std::size_t D>
Vec<D> operator-(const Vec<D>& a, const Vec<D>& b) {
  return a + Jet(-1) * b;
}
template <std::size_t D>
Jet dot(const Vec<D>& a, const Vec<D>& b) {
  Jet sum;
  for (std::size_t i = 0; i < D; ++i) sum = sum + a[i] * b[i];
  return sum;
}
template <std::size_t D>
Jet norm(const Vec<D>& a) {
  return sqrt(dot(a, a));
}
template <std::size_t D>
Vec<D> unit(const Vec<D>& a) {
  return (Jet(1) / norm(a)) * a;
}

// ——— In the plane ———

inline Vec2 polar(Jet r, Jet angle) { return {{r * cos(angle), r * sin(angle)}}; }
inline Jet angle(const Vec2& a) { return atan2(a[1], a[0]); }
/// Returns a turned by a right angle, anticlockwise.
inline Vec2 turned(const Vec2& a) { return {{-a[1], a[0]}}; }
/// Returns the angle from b to a [rad].
inline Jet angle(const Vec2& a, const Vec2& b) { return atan2(dot(turned(b), a), dot(b, a)); }

enum class Side { left, right };

/// Returns the intersection of the circles about p and q on one side of the line from p to q.
inline Vec2 meet(const Vec2& p, Jet p_radius, const Vec2& q, Jet q_radius, Side side) {
  const Vec2 w = q - p;
  const Jet w2 = dot(w, w);
  const Jet along = (p_radius * p_radius - q_radius * q_radius + w2) / (Jet(2) * w2);
  const Jet across = sqrt(p_radius * p_radius / w2 - along * along);
  return p + along * w + (side == Side::left ? across : -across) * turned(w);
}

/// Returns the position of a body's third point when its first two are at a and b. In a drawing of
/// the body the three points are at a0, b0 and c0.
inline Vec2 carried(const Vec2& a, const Vec2& b, const Vec2& a0, const Vec2& b0, const Vec2& c0) {
  const Vec2 w = b0 - a0, at = c0 - a0;
  return a + (dot(w, at) / dot(w, w)) * (b - a) + (dot(turned(w), at) / dot(w, w)) * turned(b - a);
}

// ——— In space ———

inline constexpr Vec3 x_axis{{1, 0, 0}}, y_axis{{0, 1, 0}}, z_axis{{0, 0, 1}};

inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// Returns a turned about a unit vector (Rodrigues' formula).
inline Vec3 rotated(const Vec3& a, const Vec3& axis, Jet angle) {
  const Vec3 along = dot(axis, a) * axis;
  return along + cos(angle) * (a - along) + sin(angle) * cross(axis, a);
}

/// Returns a turned by 2 atan ‖c‖ about c, where c holds three rotation parameters. It is regular
/// below half a turn.
inline Vec3 rotated(const Vec3& a, const Vec3& c) {
  const Vec3 moved = cross(c, a);
  return a + (Jet(2) / (Jet(1) + dot(c, c))) * (moved + cross(c, moved));
}

/// A body in space.
struct Body {
  Vec3 drawn, at;  ///< one of its points in the drawing, and where it is
  Vec3 turn;       ///< from the drawing, in rotation parameters

  Vec3 direction(const Vec3& a) const { return rotated(a, turn); }
  Vec3 point(const Vec3& a) const { return at + rotated(a - drawn, turn); }
};

/// Returns a body that is drawn at the origin, from its position and its turn.
inline Body body_at(const std::array<Jet, 6>& x) {
  return {{}, {{x[0], x[1], x[2]}}, {{x[3], x[4], x[5]}}};
}

/// Returns the greater of the angles θ next to atan2(b, a) with a cos θ + b sin θ = c.
inline Jet angle_with(Jet a, Jet b, Jet c) {
  return atan2(b, a) + atan2(sqrt(a * a + b * b - c * c), c);
}

}  // namespace desmo::exact
