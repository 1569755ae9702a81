#pragma once

// Constraint kinds from which the frame of a body is derived: all are explicit in their first
// operand. The concept of a kind is described in formulations/constraints/constraints.h.
//
// Euler parameters e (Haug 1989, section 9.3) turn the axes of a frame to the columns of A(e),
// which is homogeneous quadratic:
//   a₀ = (e₀² + e₁² − e₂² − e₃², 2 (e₁e₂ + e₀e₃), 2 (e₁e₃ − e₀e₂))
//   a₁ = (2 (e₁e₂ − e₀e₃), e₀² − e₁² + e₂² − e₃², 2 (e₂e₃ + e₀e₁))
// These two axes are unit vectors where e is one (Unit<4>). The third axis is their product
// (Cross).

#include <array>
#include <cmath>
#include <string_view>

#include "formulations/constraints/vec.h"

namespace desmo {

namespace vec {

/// Returns u × v in space.
template <class S>
std::array<S, 3> product(const S* u, const S* v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// Returns ∂a_k/∂e / 2, by rows.
template <int k, class S>
std::array<std::array<S, 4>, 3> half_slopes(const S* e) {
  static_assert(k == 0 || k == 1);
  if constexpr (k == 0)
    return {{{e[0], e[1], -e[2], -e[3]}, {e[3], e[2], e[1], e[0]}, {-e[2], e[3], -e[0], e[1]}}};
  else
    return {{{-e[3], e[2], e[1], -e[0]}, {e[0], -e[1], e[2], -e[3]}, {e[1], e[0], e[3], e[2]}}};
}

/// Returns ∂a_k/∂e(e) d / 2, which is a_k(e) for d = e.
template <int k, class S>
std::array<S, 3> euler_axis(const S* e, const S* d) {
  const auto slopes = half_slopes<k>(e);
  std::array<S, 3> a;
  for (int i = 0; i < 3; ++i) a[i] = dot<4>(slopes[i].data(), d);
  return a;
}

}  // namespace vec

/// Vector v, the direction Sign f turned by θ towards g: v − Sign cos θ f − sin θ g = 0. Operands
/// v, f, g, θ.
template <int Sign>
struct Turned : NonlinearKind<3> {
  static_assert(Sign == 1 || Sign == -1);
  static constexpr std::string_view name = Sign > 0 ? "turned" : "turned_opposite";
  static constexpr std::array operand_sizes{3, 3, 3, 1};
  static constexpr int constants = 0, entries = 12;

  template <class S>
  static void residual(const S* const* x, const S*, S* phi) {
    using std::cos, std::sin;
    const S cosine = S(Sign) * cos(x[3][0]), sine = sin(x[3][0]);
    for (int i = 0; i < 3; ++i) phi[i] = x[0][i] - cosine * x[1][i] - sine * x[2][i];
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    using std::cos, std::sin;
    const S cosine = cos(x[3][0]), sine = sin(x[3][0]);
    for (int i = 0; i < 3; ++i) {
      entry(i, 0, i, S(1));
      entry(i, 1, i, S(-Sign) * cosine);
      entry(i, 2, i, -sine);
      entry(i, 3, 0, S(Sign) * sine * x[1][i] - cosine * x[2][i]);
    }
  }
  template <class S>
  static void quadratic(const S* const* x, const S* const* v, const S*, S* gamma) {
    using std::cos, std::sin;
    const S cosine = cos(x[3][0]), sine = sin(x[3][0]), rate = v[3][0];
    for (int i = 0; i < 3; ++i)
      gamma[i] = rate * (rate * (S(Sign) * cosine * x[1][i] + sine * x[2][i]) +
                         S(2) * (S(Sign) * sine * v[1][i] - cosine * v[2][i]));
  }
};

/// Vector w, the cross product of two others: w − u × v = 0. Operands w, u, v.
struct Cross : NonlinearKind<3> {
  static constexpr std::string_view name = "cross";
  static constexpr std::array operand_sizes{3, 3, 3};
  static constexpr int constants = 0, entries = 15;

  template <class S>
  static void residual(const S* const* x, const S*, S* phi) {
    const auto product = vec::product(x[1], x[2]);
    for (int i = 0; i < 3; ++i) phi[i] = x[0][i] - product[i];
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;  // (u × v)ᵢ = uⱼ vₖ − uₖ vⱼ
      entry(i, 0, i, S(1));
      entry(i, 1, j, -x[2][k]);
      entry(i, 1, k, x[2][j]);
      entry(i, 2, j, x[1][k]);
      entry(i, 2, k, -x[1][j]);
    }
  }
  template <class S>
  static void quadratic(const S* const*, const S* const* v, const S*, S* gamma) {
    const auto product = vec::product(v[1], v[2]);
    for (int i = 0; i < 3; ++i) gamma[i] = S(-2) * product[i];
  }
};

/// Axis k of a frame that Euler parameters turn from the axes of space: x − a_k(e) = 0. Operands x,
/// e.
template <int k>
struct EulerAxis : NonlinearKind<3> {
  static constexpr std::string_view name = k == 0 ? "euler_axis_x" : "euler_axis_y";
  static constexpr std::array operand_sizes{3, 4};
  static constexpr int constants = 0, entries = 15;

  template <class S>
  static void residual(const S* const* x, const S*, S* phi) {
    const auto a = vec::euler_axis<k>(x[1], x[1]);
    for (int i = 0; i < 3; ++i) phi[i] = x[0][i] - a[i];
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    const auto slopes = vec::half_slopes<k>(x[1]);
    for (int i = 0; i < 3; ++i) {
      entry(i, 0, i, S(1));
      for (int j = 0; j < 4; ++j) entry(i, 1, j, S(-2) * slopes[i][j]);
    }
  }
  template <class S>
  static void quadratic(const S* const*, const S* const* v, const S*, S* gamma) {
    const auto a = vec::euler_axis<k>(v[1], v[1]);
    for (int i = 0; i < 3; ++i) gamma[i] = S(-2) * a[i];
  }
};

/// Axis k of a frame that Euler parameters turn from a triad: x − [X Y Z] a_k(e) = 0. Operands x,
/// X, Y, Z, e.
template <int k>
struct EulerAxisOn : NonlinearKind<3> {
  static constexpr std::string_view name = k == 0 ? "euler_axis_x_on" : "euler_axis_y_on";
  static constexpr std::array operand_sizes{3, 3, 3, 3, 4};
  static constexpr int constants = 0, entries = 24;

  template <class S>
  static void residual(const S* const* x, const S*, S* phi) {
    const auto a = on_triad(x, vec::euler_axis<k>(x[4], x[4]));
    for (int i = 0; i < 3; ++i) phi[i] = x[0][i] - a[i];
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    const auto a = vec::euler_axis<k>(x[4], x[4]);
    const auto slopes = vec::half_slopes<k>(x[4]);
    for (int i = 0; i < 3; ++i) {
      entry(i, 0, i, S(1));
      for (int axis = 0; axis < 3; ++axis) entry(i, 1 + axis, i, -a[axis]);
      for (int j = 0; j < 4; ++j)
        entry(i, 4, j,
              S(-2) * (x[1][i] * slopes[0][j] + x[2][i] * slopes[1][j] + x[3][i] * slopes[2][j]));
    }
  }
  template <class S>
  static void quadratic(const S* const* x, const S* const* v, const S*, S* gamma) {
    const auto fixed = on_triad(x, vec::euler_axis<k>(v[4], v[4])),
               turning = on_triad(v, vec::euler_axis<k>(x[4], v[4]));
    for (int i = 0; i < 3; ++i) gamma[i] = S(-2) * fixed[i] - S(4) * turning[i];
  }

 private:
  /// Returns [X Y Z] a.
  template <class S>
  static std::array<S, 3> on_triad(const S* const* x, const std::array<S, 3>& a) {
    std::array<S, 3> sum;
    for (int i = 0; i < 3; ++i) sum[i] = x[1][i] * a[0] + x[2][i] * a[1] + x[3][i] * a[2];
    return sum;
  }
};

}  // namespace desmo
