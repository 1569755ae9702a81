#pragma once

// Constraint kinds that define relative coordinates in the plane and in space: components and
// distances, angles in a frame, and couplings of coordinates. Angles in the plane are in
// planar_angles.h. The concept of a kind is described in formulations/constraints/constraints.h.

#include <array>
#include <cmath>
#include <string_view>

#include "formulations/constraints/rigid_body.h"
#include "formulations/constraints/table.h"
#include "formulations/constraints/vec.h"

namespace desmo {

/// A scalar coordinate equal to component Axis of a point: p_Axis − h = 0. Operands p, h.
template <int D, int Axis>
struct Component : LinearKind<1> {
  static constexpr std::string_view name = [] {
    constexpr std::string_view names[2][3] = {{"component2_x", "component2_y", ""},
                                              {"component3_x", "component3_y", "component3_z"}};
    return names[D - 2][Axis];
  }();
  static constexpr std::array operand_sizes{D, 1};
  static constexpr int constants = 0, entries = 2;

  template <class S>
  static void residual(const S* const* x, const S*, S* phi) {
    phi[0] = x[0][Axis] - x[1][0];
  }
  template <class S, class Entry>
  static void jacobian(const S* const*, const S*, Entry&& entry) {
    entry(0, 0, Axis, S(1));
    entry(0, 1, 0, S(-1));
  }
};

/// A linear relation of N scalar coordinates: Σ kᵢ sᵢ − c = 0. Operands s₁ … s_N; c = {k₁ … k_N,
/// c}. Angles count with their whole turns.
template <int N>
struct Coupling : LinearKind<1> {
  static constexpr std::string_view name =
      std::array<std::string_view, 3>{"coupling_2", "coupling_3", "coupling_4"}[N - 2];
  static constexpr auto operand_sizes = vec::sizes<N>(1);
  static constexpr int constants = N + 1, entries = N;

  template <class S>
  static void residual(const S* const* x, const S* c, S* phi) {
    phi[0] = c[0] * x[0][0];
    for (int k = 1; k < N; ++k) phi[0] = phi[0] + c[k] * x[k][0];
    phi[0] = phi[0] - c[N];
  }
  template <class S, class Entry>
  static void jacobian(const S* const*, const S* c, Entry&& entry) {
    for (int k = 0; k < N; ++k) entry(0, k, 0, c[k]);
  }
};

/// A coupling by a table f: s₁ − b − u f(k s₂) = 0. Operands s₁, s₂. A constraint has the
/// dimensions {u, k, b} and the numbers of its table (table.h). Functions take f about an argument
/// ξ in place of the table (constants_at()): c = {u, k, b, ξ, a₀ … a₃} with f = a₀ + a₁ τ + a₂ τ² +
/// a₃ τ³ and τ = k s₂ − ξ.
struct TableCoupling : NonlinearKind<1> {
  static constexpr std::string_view name = "coupling_by_table";
  static constexpr std::array operand_sizes{1, 1};
  static constexpr int constants = 8, entries = 2;
  static constexpr int table = 3;  ///< position of the table among a constraint's numbers

  template <class S>
  static void residual(const S* const* x, const S* c, S* phi) {
    const S t = offset(x, c);
    phi[0] = x[0][0] - c[2] - c[0] * (((c[7] * t + c[6]) * t + c[5]) * t + c[4]);
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S* c, Entry&& entry) {
    const S t = offset(x, c);
    entry(0, 0, 0, S(1));
    entry(0, 1, 0, -(c[0] * c[1]) * ((S(3) * c[7] * t + S(2) * c[6]) * t + c[5]));
  }
  template <class S>
  static void quadratic(const S* const* x, const S* const* v, const S* c, S* gamma) {
    const S rate = c[1] * v[1][0];
    gamma[0] = -c[0] * ((S(6) * c[7] * offset(x, c) + S(2) * c[6]) * (rate * rate));
  }

  /// Returns the constants c about ξ = k s₂ from a constraint's numbers {u, k, b, table}.
  template <class S>
  static std::array<S, constants> about(const S* c, const S& s2) {
    const S at = c[1] * s2;
    const S* const t = c + table;
    return {c[0],
            c[1],
            c[2],
            at,
            table_coefficient<0>(t, at),
            table_coefficient<1>(t, at),
            table_coefficient<2>(t, at),
            table_coefficient<3>(t, at)};
  }
  /// Returns the same as about() in a scalar that has comparisons. number(k): number k of a
  /// constraint.
  template <class S, class Number>
  static std::array<S, constants> about_number(const Number& number, const S& s2) {
    const S at = number(1) * s2;
    const auto t = [&number](int k) { return number(table + k); };
    return {number(0),
            number(1),
            number(2),
            at,
            table_number<0>(t, at),
            table_number<1>(t, at),
            table_number<2>(t, at),
            table_number<3>(t, at)};
  }

 private:
  /// Returns τ.
  template <class S>
  static S offset(const S* const* x, const S* c) {
    return c[1] * x[1][0] - c[3];
  }
};

/// Distance s of points a, b: ‖b − a‖² − s² = 0. Operands a, b, s. It holds for −s as well, and
/// does not determine ṡ at s = 0.
template <int D>
struct Distance : NonlinearKind<1> {
  static constexpr std::string_view name = D == 2 ? "distance2" : "distance3";
  static constexpr std::array operand_sizes{D, D, 1};
  static constexpr int constants = 0, entries = 2 * D + 1;

  template <class S>
  static void residual(const S* const* x, const S*, S* phi) {
    const auto s = vec::difference<D>(x[0], x[1]);
    phi[0] = vec::dot<D>(s.data(), s.data()) - x[2][0] * x[2][0];
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S* c, Entry&& entry) {
    Length<D>::jacobian(x, c, entry);
    entry(0, 2, 0, S(-2) * x[2][0]);
  }
  template <class S>
  static void quadratic(const S* const*, const S* const* v, const S*, S* gamma) {
    const auto s = vec::difference<D>(v[0], v[1]);
    gamma[0] = S(2) * (vec::dot<D>(s.data(), s.data()) - v[2][0] * v[2][0]);
  }
};

/// Angle φ of a direction w in the plane of x and z, from Sign·x towards z:
/// cos φ z·w − Sign sin φ x·w = 0. Operands x, z, then w, a vector or the points a, b of a line
/// with w = b − a, then φ. It holds modulo π; the initial estimate picks the branch.
template <int Sign, DirectionOf of>
struct FrameAngle : NonlinearKind<1> {
  static_assert(Sign == 1 || Sign == -1);
  static constexpr bool is_line = of == DirectionOf::line;
  static constexpr std::string_view name =
      Sign < 0 ? (is_line ? "frame_angle" : "frame_angle_of_vector")
               : (is_line ? "frame_angle_from_x" : "frame_angle_from_x_of_vector");
  /// Index of operand φ.
  static constexpr int angle = 2 + vec::direction_operands<of>;
  static constexpr auto operand_sizes = vec::sizes_and_scalar<angle>(3);
  static constexpr int constants = 0, entries = 3 * angle + 1;

  template <class S>
  static void residual(const S* const* q, const S*, S* phi) {
    using std::cos, std::sin;
    const auto w = vec::direction<3, of>(q + 2);
    phi[0] = cos(q[angle][0]) * vec::dot<3>(q[1], w.data()) +
             opposite(sin(q[angle][0])) * vec::dot<3>(q[0], w.data());
  }
  template <class S, class Entry>
  static void jacobian(const S* const* q, const S*, Entry&& entry) {
    using std::cos, std::sin;
    const S cosine = cos(q[angle][0]), sine = sin(q[angle][0]);
    const auto w = vec::direction<3, of>(q + 2);
    for (int i = 0; i < 3; ++i) {
      const S along = cosine * q[1][i] + opposite(sine) * q[0][i];
      entry(0, 0, i, opposite(sine) * w[i]);
      entry(0, 1, i, cosine * w[i]);
      if constexpr (is_line) entry(0, 2, i, -along);
      entry(0, angle - 1, i, along);
    }
    entry(0, angle, 0,
          opposite(cosine) * vec::dot<3>(q[0], w.data()) - sine * vec::dot<3>(q[1], w.data()));
  }
  template <class S>
  static void quadratic(const S* const* q, const S* const* v, const S*, S* gamma) {
    using std::cos, std::sin;
    const S cosine = cos(q[angle][0]), sine = sin(q[angle][0]), rate = v[angle][0];
    const auto w = vec::direction<3, of>(q + 2);
    const auto w_rate = vec::direction<3, of>(v + 2);
    // P = z·w and R = x·w, so that Φ = cos φ P − Sign sin φ R.
    const S p = vec::dot<3>(q[1], w.data()),
            p_rate = vec::dot<3>(v[1], w.data()) + vec::dot<3>(q[1], w_rate.data());
    const S r = vec::dot<3>(q[0], w.data()),
            r_rate = vec::dot<3>(v[0], w.data()) + vec::dot<3>(q[0], w_rate.data());
    gamma[0] = S(2) * (cosine * vec::dot<3>(v[1], w_rate.data()) +
                       opposite(sine) * vec::dot<3>(v[0], w_rate.data())) +
               S(2) * rate * (opposite(cosine) * r_rate - sine * p_rate) -
               rate * rate * (cosine * p + opposite(sine) * r);
  }

 private:
  /// Returns −Sign s.
  template <class S>
  static S opposite(const S& s) {
    if constexpr (Sign < 0)
      return s;
    else
      return -s;
  }
};

}  // namespace desmo
