#pragma once

// Constraint kinds of joints between the points and vectors of two bodies. Kinds that make one body
// rigid are in rigid_body.h. The concept of a kind is described in
// formulations/constraints/constraints.h.

#include <array>
#include <string_view>

#include "formulations/constraints/vec.h"

namespace desmo {

/// Distance along a vector: b − a − s d = 0, D equations. Operands a, b, d, s.
template <int D>
struct Along : NonlinearKind<D> {
  static constexpr std::string_view name = D == 2 ? "along2" : "along3";
  static constexpr std::array operand_sizes{D, D, D, 1};
  static constexpr int constants = 0, entries = 4 * D;

  template <class S>
  static void residual(const S* const* x, const S*, S* phi) {
    for (int i = 0; i < D; ++i) phi[i] = x[1][i] - x[0][i] - x[3][0] * x[2][i];
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    for (int i = 0; i < D; ++i) {
      entry(i, 0, i, S(-1));
      entry(i, 1, i, S(1));
      entry(i, 2, i, -x[3][0]);
      entry(i, 3, 0, -x[2][i]);
    }
  }
  template <class S>
  static void quadratic(const S* const*, const S* const* v, const S*, S* gamma) {
    for (int i = 0; i < D; ++i) gamma[i] = S(-2) * (v[3][0] * v[2][i]);
  }
};

/// Planar point p at a constant distance from the line through o along the unit vector u:
/// u × (p − o) − c = 0. Operands u, o, p; c = {distance}, positive where p is to the left of u.
struct Offset : QuadraticForm<Offset> {
  static constexpr std::string_view name = "offset";
  static constexpr std::array operand_sizes{2, 2, 2};
  static constexpr int entries = 6;

  template <class S>
  static void measure(const S* const* x, S* c) {
    const auto s = vec::difference<2>(x[1], x[2]);
    c[0] = vec::cross(x[0], s.data());
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    const auto s = vec::difference<2>(x[1], x[2]);
    entry(0, 0, 0, s[1]);
    entry(0, 0, 1, -s[0]);
    entry(0, 1, 0, x[0][1]);
    entry(0, 1, 1, -x[0][0]);
    entry(0, 2, 0, -x[0][1]);
    entry(0, 2, 1, x[0][0]);
  }
};

}  // namespace desmo
