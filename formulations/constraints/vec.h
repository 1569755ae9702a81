#pragma once

// Vector algebra shared by the constraint kinds, for any scalar.

#include <array>
#include <cmath>

namespace desmo {

/// Form of a direction among the operands of a kind: a vector, or a line given by two points, start
/// first.
enum class DirectionOf { vector, line };

namespace vec {

/// Returns u·v.
template <int D, class S>
S dot(const S* u, const S* v) {
  S sum = u[0] * v[0];
  for (int i = 1; i < D; ++i) sum = sum + u[i] * v[i];
  return sum;
}

/// Returns u × v in the plane: uₓ v_y − u_y vₓ.
template <class S>
S cross(const S* u, const S* v) {
  return u[0] * v[1] - u[1] * v[0];
}

/// Returns b − a.
template <int D, class S>
std::array<S, D> difference(const S* a, const S* b) {
  std::array<S, D> s;
  for (int i = 0; i < D; ++i) s[i] = b[i] - a[i];
  return s;
}

/// Returns the length of a vector.
template <int D, class S>
S norm(const S* u) {
  using std::sqrt;
  return sqrt(dot<D>(u, u));
}

/// Returns a direction: the line from operand 0 to operand 1, or the vector operand 0.
template <int D, DirectionOf of, class S>
std::array<S, D> direction(const S* const* x) {
  if constexpr (of == DirectionOf::line) {
    return difference<D>(x[0], x[1]);
  } else {
    std::array<S, D> d;
    for (int i = 0; i < D; ++i) d[i] = x[0][i];
    return d;
  }
}

/// Returns the sizes of operands that have D components each.
template <int operands>
constexpr std::array<int, operands> sizes(int D) {
  std::array<int, operands> result{};
  result.fill(D);
  return result;
}
/// Returns the sizes of operands that have D components each, and of a scalar after them.
template <int operands>
constexpr std::array<int, operands + 1> sizes_and_scalar(int D) {
  std::array<int, operands + 1> result = sizes<operands + 1>(D);
  result[operands] = 1;
  return result;
}

/// Number of operands of a direction.
template <DirectionOf of>
inline constexpr int direction_operands = of == DirectionOf::line ? 2 : 1;

}  // namespace vec

/// The common part of kinds whose residual is affine in the operands: Φ_q is constant, so
/// Φ̇_q q̇ = 0.
template <int Rows>
struct LinearKind {
  static constexpr int rows = Rows;
  static constexpr bool linear = true;

  template <class S>
  static void quadratic(const S* const*, const S* const*, const S*, S* gamma) {
    for (int i = 0; i < rows; ++i) gamma[i] = S(0);
  }
};

/// The common part of all nonlinear kinds.
template <int Rows>
struct NonlinearKind {
  static constexpr int rows = Rows;
  static constexpr bool linear = false;
};

/// The common part of kinds that keep a quadratic form of their operands constant: f(q) − c = 0,
/// so that Φ̇_q q̇ = 2 f(q̇). Kind::measure() writes f, with +, − and * alone.
template <class Kind>
struct QuadraticForm : NonlinearKind<1> {
  static constexpr int constants = 1;

  template <class S>
  static void residual(const S* const* x, const S* c, S* phi) {
    S form;
    Kind::measure(x, &form);
    phi[0] = form - c[0];
  }
  template <class S>
  static void quadratic(const S* const*, const S* const* v, const S*, S* gamma) {
    S form;
    Kind::measure(v, &form);
    gamma[0] = S(2) * form;
  }
};

}  // namespace desmo
