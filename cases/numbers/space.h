#pragma once

// Products and rotations of vectors in space, for any scalar S.

#include <array>
#include <cmath>

namespace desmo {

template <class S>
S dot(const std::array<S, 3>& a, const std::array<S, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class S>
std::array<S, 3> cross(const std::array<S, 3>& a, const std::array<S, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Returns a vector turned by an angle [rad] about an axis of length 1 (Rodrigues).
template <class S>
std::array<S, 3> turned_about(const std::array<S, 3>& axis, S angle, const std::array<S, 3>& v) {
  using std::cos;
  using std::sin;
  const S cosine = cos(angle), sine = sin(angle);
  const S along = (S(1) - cosine) * dot(axis, v);
  const std::array<S, 3> across = cross(axis, v);
  std::array<S, 3> result;
  for (int i = 0; i < 3; ++i) result[i] = cosine * v[i] + sine * across[i] + along * axis[i];
  return result;
}

}  // namespace desmo
