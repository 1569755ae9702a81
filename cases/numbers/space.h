#pragma once

// Products of vectors in space, for any scalar.

#include <array>

namespace desmo {

template <class S>
S dot(const std::array<S, 3>& a, const std::array<S, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class S>
std::array<S, 3> cross(const std::array<S, 3>& a, const std::array<S, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace desmo
