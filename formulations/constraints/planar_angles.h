#pragma once

// Constraint kinds that define angles of directions in the plane. The concept of a kind is
// described in formulations/constraints/constraints.h.

#include <array>
#include <cmath>
#include <string_view>

#include "formulations/constraints/vec.h"

namespace desmo {

/// Angle θ of a plane line from the x axis: b − a − L (cos θ, sin θ) = 0, two equations.
/// Operands a, b, θ; c = {L}.
struct PlanarAngle : NonlinearKind<2> {
  static constexpr std::string_view name = "planar_angle";
  static constexpr std::array operand_sizes{2, 2, 1};
  static constexpr int constants = 1, entries = 6;

  template <class S>
  static void residual(const S* const* x, const S* c, S* phi) {
    using std::cos, std::sin;
    phi[0] = x[1][0] - x[0][0] - c[0] * cos(x[2][0]);
    phi[1] = x[1][1] - x[0][1] - c[0] * sin(x[2][0]);
  }
  template <class S>
  static void measure(const S* const* x, S* c) {
    const auto s = vec::difference<2>(x[0], x[1]);
    c[0] = vec::norm<2>(s.data());
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S* c, Entry&& entry) {
    using std::cos, std::sin;
    for (int i = 0; i < 2; ++i) {
      entry(i, 0, i, S(-1));
      entry(i, 1, i, S(1));
    }
    entry(0, 2, 0, c[0] * sin(x[2][0]));
    entry(1, 2, 0, -(c[0] * cos(x[2][0])));
  }
  template <class S>
  static void quadratic(const S* const* x, const S* const* v, const S* c, S* gamma) {
    using std::cos, std::sin;
    const S rate2 = v[2][0] * v[2][0];
    gamma[0] = c[0] * cos(x[2][0]) * rate2;
    gamma[1] = c[0] * sin(x[2][0]) * rate2;
  }
};

/// Angle θ of a plane unit vector from the x axis: u − (cos θ, sin θ) = 0, two equations. Operands
/// u, θ. It makes u a unit vector, too.
struct PlanarDirection : NonlinearKind<2> {
  static constexpr std::string_view name = "planar_direction";
  static constexpr std::array operand_sizes{2, 1};
  static constexpr int constants = 0, entries = 4;

  template <class S>
  static void residual(const S* const* x, const S*, S* phi) {
    using std::cos, std::sin;
    phi[0] = x[0][0] - cos(x[1][0]);
    phi[1] = x[0][1] - sin(x[1][0]);
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    using std::cos, std::sin;
    entry(0, 0, 0, S(1));
    entry(1, 0, 1, S(1));
    entry(0, 1, 0, sin(x[1][0]));
    entry(1, 1, 0, -cos(x[1][0]));
  }
  template <class S>
  static void quadratic(const S* const* x, const S* const* v, const S*, S* gamma) {
    using std::cos, std::sin;
    const S rate2 = v[1][0] * v[1][0];
    gamma[0] = cos(x[1][0]) * rate2;
    gamma[1] = sin(x[1][0]) * rate2;
  }
};

namespace vec {

/// Scaled rotation r R(θ): turns a plane vector by θ counter-clockwise and stretches it by r.
template <class S>
struct ScaledRotation {
  S cosine, sine;  ///< r cos θ, r sin θ

  ScaledRotation(const S& ratio, const S& angle) {
    using std::cos, std::sin;
    cosine = ratio * cos(angle);
    sine = ratio * sin(angle);
  }
  /// Returns r R(θ) e.
  std::array<S, 2> operator()(const std::array<S, 2>& e) const {
    return {cosine * e[0] - sine * e[1], sine * e[0] + cosine * e[1]};
  }
  /// Returns the entry of r R(θ) in row i and column `other` ≠ i.
  S across(int i) const { return i == 0 ? -sine : sine; }
};

/// Writes the quadratic term of −r R(θ) e: θ̇² f − 2 θ̇ J g. Here f = r R(θ) e, g = r R(θ) ė, and J
/// is the quarter turn counter-clockwise.
/// - rate: θ̇
/// - gamma: (2), overwritten
template <class S>
void quadratic_of_turn(const std::array<S, 2>& f, const std::array<S, 2>& g, const S& rate,
                       S* gamma) {
  gamma[0] = rate * (rate * f[0] + S(2) * g[1]);
  gamma[1] = rate * (rate * f[1] - S(2) * g[0]);
}

}  // namespace vec

/// The plane directions d and e between which an angle is measured, from e to d, as they stand
/// among the operands of a kind. A direction is one vector, or the two points of a line, start
/// first.
enum class Between {
  vector_and_vector,  ///< d, e, θ
  vector_and_line,    ///< d, start of e, end of e, θ
  line_and_vector,    ///< start of d, end of d, e, θ
  line_and_line,      ///< start of d, end of d, start of e, end of e, θ: four different points
  lines_at_point,     ///< common start of both lines, end of d, end of e, θ
};

namespace vec {

/// The operands d, e and θ of an angle.
template <Between between>
struct AngleOperands {
  static constexpr bool at_point = between == Between::lines_at_point;
  static constexpr bool of_line = between >= Between::line_and_vector;
  static constexpr bool from_line =
      between == Between::vector_and_line || between >= Between::line_and_line;
  static constexpr DirectionOf form_of_d = of_line ? DirectionOf::line : DirectionOf::vector;
  static constexpr DirectionOf form_of_e = from_line ? DirectionOf::line : DirectionOf::vector;
  /// Index of the first operand of e that is not one of d.
  static constexpr int first_of_e = direction_operands<form_of_d>;
  /// Index of operand θ.
  static constexpr int theta = first_of_e + (from_line && !at_point ? 2 : 1);
  static constexpr auto operand_sizes = sizes_and_scalar<theta>(2);

  template <class S>
  static std::array<S, 2> d(const S* const* x) {
    return direction<2, form_of_d>(x);
  }
  template <class S>
  static std::array<S, 2> e(const S* const* x) {
    if constexpr (at_point)
      return difference<2>(x[0], x[theta - 1]);
    else
      return direction<2, form_of_e>(x + first_of_e);
  }
  /// Measures the ratio ‖d‖/‖e‖, where vectors count as unit vectors.
  template <class S>
  static void measure(const S* const* x, S* c) {
    const auto length = [](bool line, const std::array<S, 2>& u) {
      return line ? norm<2>(u.data()) : S(1);
    };
    c[0] = length(of_line, d(x)) / length(from_line, e(x));
  }
};

}  // namespace vec

/// Angle θ of a plane direction d from a direction e, counter-clockwise: d − r R(θ) e = 0, two
/// equations. R(θ) turns by θ; c = {r}, the constant ratio ‖d‖/‖e‖.
template <Between between>
struct PlanarTurn : NonlinearKind<2>, vec::AngleOperands<between> {
  using Operands = vec::AngleOperands<between>;
  using Operands::theta;
  // Names of kinds say "segment" for a line: fingerprints hold them, so they stay as they are.
  static constexpr std::string_view name = std::array<std::string_view, 5>{
      "planar_turn_vector_from_vector", "planar_turn_vector_from_segment",
      "planar_turn_segment_from_vector", "planar_turn_segment_from_segment",
      "planar_turn_at_point"}[static_cast<int>(between)];
  static constexpr int constants = 1;
  static constexpr int entries =
      2 * ((Operands::of_line ? 2 : 1) + (Operands::from_line ? 4 : 2) + 1) -
      (Operands::at_point ? 2 : 0);

  template <class S>
  static void residual(const S* const* x, const S* c, S* phi) {
    const vec::ScaledRotation<S> turn(c[0], x[theta][0]);
    const auto d = Operands::d(x);
    const auto f = turn(Operands::e(x));
    for (int i = 0; i < 2; ++i) phi[i] = d[i] - f[i];
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S* c, Entry&& entry) {
    constexpr int e = Operands::first_of_e;
    const vec::ScaledRotation<S> turn(c[0], x[theta][0]);
    const auto f = turn(Operands::e(x));
    for (int i = 0; i < 2; ++i) {
      const int other = 1 - i;
      if constexpr (Operands::at_point) {
        entry(i, 0, i, turn.cosine - S(1));
        entry(i, 0, other, turn.across(i));
      } else if constexpr (Operands::of_line) {
        entry(i, 0, i, S(-1));
      }
      entry(i, e - 1, i, S(1));
      if constexpr (Operands::from_line && !Operands::at_point) {
        entry(i, e, i, turn.cosine);
        entry(i, e, other, turn.across(i));
      }
      entry(i, theta - 1, i, -turn.cosine);
      entry(i, theta - 1, other, -turn.across(i));
    }
    entry(0, theta, 0, f[1]);
    entry(1, theta, 0, -f[0]);
  }
  template <class S>
  static void quadratic(const S* const* x, const S* const* v, const S* c, S* gamma) {
    const vec::ScaledRotation<S> turn(c[0], x[theta][0]);
    vec::quadratic_of_turn(turn(Operands::e(x)), turn(Operands::e(v)), v[theta][0], gamma);
  }
};

}  // namespace desmo
