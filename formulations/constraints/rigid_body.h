#pragma once

// Constraint kinds that make bodies rigid: constant lengths, angles and combinations of points and
// vectors. The concept of a kind is described in formulations/constraints/constraints.h.

#include <array>
#include <string_view>

#include "formulations/constraints/vec.h"

namespace desmo {

/// Points a, b at constant distance: ‖b − a‖² − L² = 0.   c = {L²}
template <int D>
struct Length : QuadraticForm<Length<D>> {
  static constexpr std::string_view name = D == 2 ? "length2" : "length3";
  static constexpr std::array operand_sizes{D, D};
  static constexpr int entries = 2 * D;

  template <class S>
  static void measure(const S* const* x, S* c) {
    const auto s = vec::difference<D>(x[0], x[1]);
    c[0] = vec::dot<D>(s.data(), s.data());
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    for (int i = 0; i < D; ++i) {
      const S d = S(2) * (x[1][i] - x[0][i]);
      entry(0, 0, i, -d);
      entry(0, 1, i, d);
    }
  }
};

/// Unit vector u: u·u − 1 = 0. With D = 4, the norm of Euler parameters.
template <int D>
struct Unit : NonlinearKind<1> {
  static constexpr std::string_view name = D == 2 ? "unit2" : D == 3 ? "unit3" : "unit4";
  static constexpr std::array operand_sizes{D};
  static constexpr int constants = 0, entries = D;

  template <class S>
  static void residual(const S* const* x, const S*, S* phi) {
    phi[0] = vec::dot<D>(x[0], x[0]) - S(1);
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    for (int i = 0; i < D; ++i) entry(0, 0, i, S(2) * x[0][i]);
  }
  template <class S>
  static void quadratic(const S* const*, const S* const* v, const S*, S* gamma) {
    gamma[0] = S(2) * vec::dot<D>(v[0], v[0]);
  }
};

/// Vectors u, v with constant product: u·v − c = 0.   c = {cosine of the angle of unit vectors}
template <int D>
struct Dot : QuadraticForm<Dot<D>> {
  static constexpr std::string_view name = D == 2 ? "dot2" : "dot3";
  static constexpr std::array operand_sizes{D, D};
  static constexpr int entries = 2 * D;

  template <class S>
  static void measure(const S* const* x, S* c) {
    c[0] = vec::dot<D>(x[0], x[1]);
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    for (int i = 0; i < D; ++i) {
      entry(0, 0, i, x[1][i]);
      entry(0, 1, i, x[0][i]);
    }
  }
};

/// Constant projection of the line from a to b on the vector u: u·(b − a) − c = 0. Operands u, a,
/// b; c = {projection, if u is a unit vector}.
template <int D>
struct Projection : QuadraticForm<Projection<D>> {
  static constexpr std::string_view name = D == 2 ? "projection2" : "projection3";
  static constexpr std::array operand_sizes{D, D, D};
  static constexpr int entries = 3 * D;

  template <class S>
  static void measure(const S* const* x, S* c) {
    const auto s = vec::difference<D>(x[1], x[2]);
    c[0] = vec::dot<D>(x[0], s.data());
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    for (int i = 0; i < D; ++i) {
      entry(0, 0, i, x[2][i] - x[1][i]);
      entry(0, 1, i, -x[0][i]);
      entry(0, 2, i, x[0][i]);
    }
  }
};

/// Rigid combination: p − o − Σ cᵢ vᵢ = 0 for T vectors, D equations. Operands p, o, v₁ … v_T;
/// c = {c₁ … c_T}. With T = 0, p coincides with o (a point, or a vector held in a direction).
template <int D, int T>
struct Rigid : LinearKind<D> {
  static constexpr std::string_view name = [] {
    constexpr std::string_view names[2][4] = {{"rigid2_0", "rigid2_1", "rigid2_2", "rigid2_3"},
                                              {"rigid3_0", "rigid3_1", "rigid3_2", "rigid3_3"}};
    return names[D - 2][T];
  }();
  static constexpr auto operand_sizes = vec::sizes<T + 2>(D);
  static constexpr int constants = T, entries = D * (T + 2);

  template <class S>
  static void residual(const S* const* x, const S* c, S* phi) {
    for (int i = 0; i < D; ++i) {
      phi[i] = x[0][i] - x[1][i];
      for (int k = 0; k < T; ++k) phi[i] = phi[i] - c[k] * x[k + 2][i];
    }
  }
  /// Measures along a unit vector that points from o to p.
  template <class S>
  static void measure(const S* const* x, S* c) requires(T == 1) {
    const auto s = vec::difference<D>(x[1], x[0]);
    c[0] = vec::norm<D>(s.data());
  }
  template <class S, class Entry>
  static void jacobian(const S* const*, const S* c, Entry&& entry) {
    for (int i = 0; i < D; ++i) {
      entry(i, 0, i, S(1));
      entry(i, 1, i, S(-1));
      for (int k = 0; k < T; ++k) entry(i, k + 2, i, -c[k]);
    }
  }
};

/// Combination of T vectors or points: p − Σ cᵢ eᵢ = 0, D equations. Operands p, e₁ … e_T;
/// c = {c₁ … c_T}. A point is a combination of points when Σ cᵢ = 1.
template <int D, int T>
struct Combination : LinearKind<D> {
  static_assert(D == 3);
  static constexpr std::string_view name = std::array<std::string_view, 4>{
      "combination3_1", "combination3_2", "combination3_3", "combination3_4"}[T - 1];
  static constexpr auto operand_sizes = vec::sizes<T + 1>(D);
  static constexpr int constants = T, entries = D * (T + 1);

  template <class S>
  static void residual(const S* const* x, const S* c, S* phi) {
    for (int i = 0; i < D; ++i) {
      phi[i] = x[0][i];
      for (int k = 0; k < T; ++k) phi[i] = phi[i] - c[k] * x[k + 1][i];
    }
  }
  template <class S, class Entry>
  static void jacobian(const S* const*, const S* c, Entry&& entry) {
    for (int i = 0; i < D; ++i) {
      entry(i, 0, i, S(1));
      for (int k = 0; k < T; ++k) entry(i, k + 1, i, -c[k]);
    }
  }
};

/// Entity that a planar relation defines.
enum class PlanarTarget { vector, point };

/// Definition of a point or vector p of a planar body by a direction d of the body, two equations.
/// J is the quarter turn counter-clockwise, J (x, y) = (−y, x); c = {c₁, c₂}.
///   point:   p − a − c₁ d − c₂ J d = 0
///   vector:  p − c₁ d − c₂ J d = 0
/// Operands p, then the origin a (of a point), then d: a vector x, or the points a and b of a line,
/// d = b − a. The line of a point starts at its origin, which is listed once: p, a, b.
template <PlanarTarget target, DirectionOf of>
struct PlanarRelation : LinearKind<2> {
  static constexpr bool is_point = target == PlanarTarget::point;
  static constexpr bool is_line = of == DirectionOf::line;
  static constexpr std::string_view name =
      is_point ? (is_line ? "planar_point_by_segment" : "planar_point_by_vector")
               : (is_line ? "planar_vector_by_segment" : "planar_vector_by_vector");
  /// Index of the operand that is d, or the start of its line.
  static constexpr int first = is_point && !is_line ? 2 : 1;
  static constexpr auto operand_sizes = vec::sizes<first + vec::direction_operands<of>>(2);
  static constexpr int constants = 2, entries = is_line ? 10 : is_point ? 8 : 6;

  template <class S>
  static void residual(const S* const* x, const S* c, S* phi) {
    const auto d = vec::direction<2, of>(x + first);
    phi[0] = x[0][0] - c[0] * d[0] + c[1] * d[1];
    phi[1] = x[0][1] - c[0] * d[1] - c[1] * d[0];
    if constexpr (is_point)
      for (int i = 0; i < 2; ++i) phi[i] = phi[i] - x[1][i];
  }
  template <class S>
  static void measure(const S* const* x, S* c) {
    const auto d = vec::direction<2, of>(x + first);
    const auto p = vec::direction<2, DirectionOf::vector>(x);
    const auto from_origin = is_point ? vec::difference<2>(x[1], x[0]) : p;
    const S square = vec::dot<2>(d.data(), d.data());
    c[0] = vec::dot<2>(d.data(), from_origin.data()) / square;
    c[1] = vec::cross(d.data(), from_origin.data()) / square;
  }
  template <class S, class Entry>
  static void jacobian(const S* const*, const S* c, Entry&& entry) {
    for (int i = 0; i < 2; ++i) {
      const int other = 1 - i;
      const S across = i == 0 ? c[1] : -c[1];  // −c₂ J
      entry(i, 0, i, S(1));
      if constexpr (is_point && !is_line) entry(i, 1, i, S(-1));
      if constexpr (is_line) {
        entry(i, first, i, is_point ? c[0] - S(1) : c[0]);
        entry(i, first, other, -across);
      }
      constexpr int last = operand_sizes.size() - 1;
      entry(i, last, i, -c[0]);
      entry(i, last, other, across);
    }
  }
};

}  // namespace desmo
