#pragma once

// Constraint kinds that define a relative coordinate by one equation. They serve where other
// equations already fix the length of the direction, or keep the point on its line. Elsewhere one
// equation would be singular in some positions and hold in wrong ones: planar_angles.h and joints.h
// have kinds with several equations. constraints.h describes a kind.

#include <array>
#include <cmath>
#include <string_view>

#include "formulations/constraints/joints.h"
#include "formulations/constraints/planar_angles.h"
#include "formulations/constraints/vec.h"

namespace desmo {

/// Distance s from a to b along the unit vector u: u·(b − a) − s = 0. Operands a, b, u, s.
template <int D>
struct Reach : NonlinearKind<1> {
  static constexpr std::string_view name = D == 2 ? "reach2" : "reach3";
  static constexpr std::array operand_sizes{D, D, D, 1};
  static constexpr int constants = 0, entries = 3 * D + 1;

  template <class S>
  static void residual(const S* const* x, const S*, S* phi) {
    const auto d = vec::difference<D>(x[0], x[1]);
    phi[0] = vec::dot<D>(x[2], d.data()) - x[3][0];
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    for (int i = 0; i < D; ++i) {
      entry(0, 0, i, -x[2][i]);
      entry(0, 1, i, x[2][i]);
      entry(0, 2, i, x[1][i] - x[0][i]);
    }
    entry(0, 3, 0, S(-1));
  }
  template <class S>
  static void quadratic(const S* const*, const S* const* v, const S*, S* gamma) {
    const auto d = vec::difference<D>(v[0], v[1]);
    gamma[0] = S(2) * vec::dot<D>(v[2], d.data());
  }
};

namespace vec {

/// The equation Φ = f × d = 0 and its derivatives: the plane direction d is parallel to f = r R(θ)
/// e, the direction e turned by θ and scaled by the constant r.
template <class S>
struct Parallel {
  std::array<S, 2> f, d;

  S residual() const { return cross(f.data(), d.data()); }
  /// Returns ∂Φ/∂dᵢ.
  S of_d(int i) const { return i == 0 ? -f[1] : f[0]; }
  /// Returns ∂Φ/∂θ.
  S of_theta() const { return -dot<2>(f.data(), d.data()); }
  /// Returns ∂Φ/∂eᵢ. turn: r R(θ).
  S of_e(const ScaledRotation<S>& turn, int i) const {
    return i == 0 ? turn.cosine * d[1] - turn.sine * d[0]
                  : -(turn.sine * d[1] + turn.cosine * d[0]);
  }
  /// Returns the quadratic term of Φ. g: r R(θ) ė. rate: θ̇.
  S quadratic(const std::array<S, 2>& g, const std::array<S, 2>& d_rate, const S& rate) const {
    std::array<S, 2> minus_f2;  // −f̈, without terms in θ̈ and ë
    quadratic_of_turn(f, g, rate, minus_f2.data());
    const std::array<S, 2> f1{g[0] - rate * f[1], g[1] + rate * f[0]};  // ḟ
    return S(2) * cross(f1.data(), d_rate.data()) - cross(minus_f2.data(), d.data());
  }
};

}  // namespace vec

/// Angle θ of a plane direction d from the x axis: (cos θ, sin θ) × d = 0. Operands d, θ. The
/// direction is a vector, or the points a, b of a line with d = b − a. It holds modulo π.
template <DirectionOf of>
struct PlanarBearing : NonlinearKind<1> {
  static constexpr bool is_line = of == DirectionOf::line;
  static constexpr std::string_view name = is_line ? "planar_bearing" : "planar_bearing_of_vector";
  static constexpr int theta = vec::direction_operands<of>;
  static constexpr auto operand_sizes = vec::sizes_and_scalar<theta>(2);
  static constexpr int constants = 0, entries = 2 * theta + 1;

  template <class S>
  static void residual(const S* const* x, const S*, S* phi) {
    phi[0] = parallel(x).residual();
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    const vec::Parallel<S> p = parallel(x);
    for (int i = 0; i < 2; ++i) {
      if constexpr (is_line) entry(0, 0, i, -p.of_d(i));
      entry(0, theta - 1, i, p.of_d(i));
    }
    entry(0, theta, 0, p.of_theta());
  }
  template <class S>
  static void quadratic(const S* const* x, const S* const* v, const S*, S* gamma) {
    gamma[0] = parallel(x).quadratic({S(0), S(0)}, vec::direction<2, of>(v), v[theta][0]);
  }

 private:
  template <class S>
  static vec::Parallel<S> parallel(const S* const* x) {
    using std::cos, std::sin;
    return {{cos(x[theta][0]), sin(x[theta][0])}, vec::direction<2, of>(x)};
  }
};

/// Angle θ of a plane direction d from a direction e, counter-clockwise: r R(θ) e × d = 0.
/// Operands, r and R(θ) as in PlanarTurn; c = {r}. It holds modulo π.
template <Between between>
struct PlanarBearingFrom : NonlinearKind<1>, vec::AngleOperands<between> {
  using Operands = vec::AngleOperands<between>;
  using Operands::theta;
  static constexpr std::string_view name = std::array<std::string_view, 5>{
      "planar_bearing_vector_from_vector", "planar_bearing_vector_from_segment",
      "planar_bearing_segment_from_vector", "planar_bearing_segment_from_segment",
      "planar_bearing_at_point"}[static_cast<int>(between)];
  static constexpr int constants = 1, entries = 2 * theta + 1;

  template <class S>
  static void residual(const S* const* x, const S* c, S* phi) {
    phi[0] = parallel(x, vec::ScaledRotation<S>(c[0], x[theta][0])).residual();
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S* c, Entry&& entry) {
    constexpr int e = Operands::first_of_e;
    const vec::ScaledRotation<S> turn(c[0], x[theta][0]);
    const vec::Parallel<S> p = parallel(x, turn);
    for (int i = 0; i < 2; ++i) {
      const S of_e = p.of_e(turn, i);
      if constexpr (Operands::at_point)
        entry(0, 0, i, -p.of_d(i) - of_e);
      else if constexpr (Operands::of_line)
        entry(0, 0, i, -p.of_d(i));
      entry(0, e - 1, i, p.of_d(i));
      if constexpr (Operands::from_line && !Operands::at_point) entry(0, e, i, -of_e);
      entry(0, theta - 1, i, of_e);
    }
    entry(0, theta, 0, p.of_theta());
  }
  template <class S>
  static void quadratic(const S* const* x, const S* const* v, const S* c, S* gamma) {
    const vec::ScaledRotation<S> turn(c[0], x[theta][0]);
    gamma[0] = parallel(x, turn).quadratic(turn(Operands::e(v)), Operands::d(v), v[theta][0]);
  }

 private:
  template <class S>
  static vec::Parallel<S> parallel(const S* const* x, const vec::ScaledRotation<S>& turn) {
    return {turn(Operands::e(x)), Operands::d(x)};
  }
};

/// Returns the kind that replaces another where other equations imply all but one of its equations.
/// The replacing kind has one equation and the same operands. Its constants are the leading ones of
/// the kind that it replaces. void: there is no such kind.
void scalar_definition(...);
template <int D>
Reach<D> scalar_definition(Along<D>);
PlanarBearing<DirectionOf::line> scalar_definition(PlanarAngle);
PlanarBearing<DirectionOf::vector> scalar_definition(PlanarDirection);
template <Between between>
PlanarBearingFrom<between> scalar_definition(PlanarTurn<between>);

template <class Kind>
using ScalarDefinition = decltype(scalar_definition(Kind{}));

}  // namespace desmo
