#pragma once

// The constraint kinds in natural and mixed coordinates (García de Jalón & Bayo), each written
// once and templated on the scalar: double evaluates, an extended type checks, a recording scalar
// yields the expression from which code is generated.
//
// A kind has
//   name            stable, part of the fingerprint of a group
//   operand_sizes   components of each entity it joins, in order
//   constants       how many dimensions of the mechanism it takes
//   rows            how many scalar equations it contributes
//   entries         how many partial derivatives it emits
//   linear          true when all partial derivatives are constant
// and three functions, where x[k] points at the first component of operand k, v[k] at its
// velocity and c at the constants:
//   residual(x, c, phi)        phi[rows] = Φ, overwritten
//   jacobian(x, c, entry)      entry(row, operand, component, ∂Φ_row/∂x[operand][component]),
//                              always the same entries in the same order
//   quadratic(x, v, c, gamma)  gamma[rows] = Φ̇_q q̇, the quadratic velocity term of eq. (4),
//                              overwritten
// Lengths are in the unit of the mechanism, angles in radians.

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <utility>

namespace desmo {

namespace vec {

template <int D, class S>
S dot(const S* u, const S* v) {
  S sum = u[0] * v[0];
  for (int i = 1; i < D; ++i) sum = sum + u[i] * v[i];
  return sum;
}

/// b − a
template <int D, class S>
std::array<S, D> segment(const S* a, const S* b) {
  std::array<S, D> s;
  for (int i = 0; i < D; ++i) s[i] = b[i] - a[i];
  return s;
}

}  // namespace vec

/// Points a, b at constant distance: ‖b − a‖² − L² = 0.   c = {L²}
template <int D>
struct Length {
  static constexpr std::string_view name = D == 2 ? "length2" : "length3";
  static constexpr std::array operand_sizes{D, D};
  static constexpr int constants = 1, rows = 1, entries = 2 * D;
  static constexpr bool linear = false;

  template <class S>
  static void residual(const S* const* x, const S* c, S* phi) {
    const auto s = vec::segment<D>(x[0], x[1]);
    phi[0] = vec::dot<D>(s.data(), s.data()) - c[0];
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    for (int i = 0; i < D; ++i) {
      const S d = S(2) * (x[1][i] - x[0][i]);
      entry(0, 0, i, -d);
      entry(0, 1, i, d);
    }
  }
  template <class S>
  static void quadratic(const S* const*, const S* const* v, const S*, S* gamma) {
    const auto s = vec::segment<D>(v[0], v[1]);
    gamma[0] = S(2) * vec::dot<D>(s.data(), s.data());
  }
};

/// Unit vector u: u·u − 1 = 0.
template <int D>
struct Unit {
  static constexpr std::string_view name = D == 2 ? "unit2" : "unit3";
  static constexpr std::array operand_sizes{D};
  static constexpr int constants = 0, rows = 1, entries = D;
  static constexpr bool linear = false;

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

/// Vectors u, v at a constant angle: u·v − c = 0.   c = {cosine of the angle}
template <int D>
struct Dot {
  static constexpr std::string_view name = D == 2 ? "dot2" : "dot3";
  static constexpr std::array operand_sizes{D, D};
  static constexpr int constants = 1, rows = 1, entries = 2 * D;
  static constexpr bool linear = false;

  template <class S>
  static void residual(const S* const* x, const S* c, S* phi) {
    phi[0] = vec::dot<D>(x[0], x[1]) - c[0];
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    for (int i = 0; i < D; ++i) {
      entry(0, 0, i, x[1][i]);
      entry(0, 1, i, x[0][i]);
    }
  }
  template <class S>
  static void quadratic(const S* const*, const S* const* v, const S*, S* gamma) {
    gamma[0] = S(2) * vec::dot<D>(v[0], v[1]);
  }
};

/// Vector u and points a, b with constant projection: u·(b − a) − c = 0.   c = {projection}
template <int D>
struct Projection {
  static constexpr std::string_view name = D == 2 ? "projection2" : "projection3";
  static constexpr std::array operand_sizes{D, D, D};
  static constexpr int constants = 1, rows = 1, entries = 3 * D;
  static constexpr bool linear = false;

  template <class S>
  static void residual(const S* const* x, const S* c, S* phi) {
    const auto s = vec::segment<D>(x[1], x[2]);
    phi[0] = vec::dot<D>(x[0], s.data()) - c[0];
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S*, Entry&& entry) {
    for (int i = 0; i < D; ++i) {
      entry(0, 0, i, x[2][i] - x[1][i]);
      entry(0, 1, i, -x[0][i]);
      entry(0, 2, i, x[0][i]);
    }
  }
  template <class S>
  static void quadratic(const S* const*, const S* const* v, const S*, S* gamma) {
    const auto s = vec::segment<D>(v[1], v[2]);
    gamma[0] = S(2) * vec::dot<D>(v[0], s.data());
  }
};

/// Rigid combination: p − o − Σ cᵢ vᵢ = 0 for T vectors, D equations. Operands p, o, v₁ … v_T;
/// c = {c₁ … c_T}. With T = 0, p coincides with o (a point, or a vector held in a direction).
template <int D, int T>
struct Rigid {
  static constexpr std::string_view name = [] {
    constexpr std::string_view names[2][4] = {{"rigid2_0", "rigid2_1", "rigid2_2", "rigid2_3"},
                                              {"rigid3_0", "rigid3_1", "rigid3_2", "rigid3_3"}};
    return names[D - 2][T];
  }();
  static constexpr std::array<int, T + 2> operand_sizes = [] {
    std::array<int, T + 2> sizes{};
    sizes.fill(D);
    return sizes;
  }();
  static constexpr int constants = T, rows = D, entries = D * (T + 2);
  static constexpr bool linear = true;

  template <class S>
  static void residual(const S* const* x, const S* c, S* phi) {
    for (int i = 0; i < D; ++i) {
      phi[i] = x[0][i] - x[1][i];
      for (int k = 0; k < T; ++k) phi[i] = phi[i] - c[k] * x[k + 2][i];
    }
  }
  template <class S, class Entry>
  static void jacobian(const S* const*, const S* c, Entry&& entry) {
    for (int i = 0; i < D; ++i) {
      entry(i, 0, i, S(1));
      entry(i, 1, i, S(-1));
      for (int k = 0; k < T; ++k) entry(i, k + 2, i, -c[k]);
    }
  }
  template <class S>
  static void quadratic(const S* const*, const S* const*, const S*, S* gamma) {
    for (int i = 0; i < D; ++i) gamma[i] = S(0);
  }
};

/// Distance along a vector: b − a − s d = 0, D equations. Operands a, b, d, s.
template <int D>
struct Along {
  static constexpr std::string_view name = D == 2 ? "along2" : "along3";
  static constexpr std::array operand_sizes{D, D, D, 1};
  static constexpr int constants = 0, rows = D, entries = 4 * D;
  static constexpr bool linear = false;

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

/// A scalar coordinate equal to component Axis of a point: p_Axis − h = 0. Operands p, h.
template <int D, int Axis>
struct Component {
  static constexpr std::string_view name = [] {
    constexpr std::string_view names[2][3] = {{"component2_x", "component2_y", ""},
                                              {"component3_x", "component3_y", "component3_z"}};
    return names[D - 2][Axis];
  }();
  static constexpr std::array operand_sizes{D, 1};
  static constexpr int constants = 0, rows = 1, entries = 2;
  static constexpr bool linear = true;

  template <class S>
  static void residual(const S* const* x, const S*, S* phi) {
    phi[0] = x[0][Axis] - x[1][0];
  }
  template <class S, class Entry>
  static void jacobian(const S* const*, const S*, Entry&& entry) {
    entry(0, 0, Axis, S(1));
    entry(0, 1, 0, S(-1));
  }
  template <class S>
  static void quadratic(const S* const*, const S* const*, const S*, S* gamma) {
    gamma[0] = S(0);
  }
};

/// Angle θ of a plane segment from the x axis: b − a − L (cos θ, sin θ) = 0, two equations.
/// Operands a, b, θ; c = {L}.
struct PlanarAngle {
  static constexpr std::string_view name = "planar_angle";
  static constexpr std::array operand_sizes{2, 2, 1};
  static constexpr int constants = 1, rows = 2, entries = 6;
  static constexpr bool linear = false;

  template <class S>
  static void residual(const S* const* x, const S* c, S* phi) {
    using std::cos;
    using std::sin;
    phi[0] = x[1][0] - x[0][0] - c[0] * cos(x[2][0]);
    phi[1] = x[1][1] - x[0][1] - c[0] * sin(x[2][0]);
  }
  template <class S, class Entry>
  static void jacobian(const S* const* x, const S* c, Entry&& entry) {
    using std::cos;
    using std::sin;
    for (int i = 0; i < 2; ++i) {
      entry(i, 0, i, S(-1));
      entry(i, 1, i, S(1));
    }
    entry(0, 2, 0, c[0] * sin(x[2][0]));
    entry(1, 2, 0, -(c[0] * cos(x[2][0])));
  }
  template <class S>
  static void quadratic(const S* const* x, const S* const* v, const S* c, S* gamma) {
    using std::cos;
    using std::sin;
    const S rate2 = v[2][0] * v[2][0];
    gamma[0] = c[0] * cos(x[2][0]) * rate2;
    gamma[1] = c[0] * sin(x[2][0]) * rate2;
  }
};

/// Angle φ of a segment in the plane of x and z, from −x towards z:
/// cos φ z·(b − a) + sin φ x·(b − a) = 0. Operands x, z, a, b, φ. It holds modulo π; the initial
/// estimate picks the branch.
struct FrameAngle {
  static constexpr std::string_view name = "frame_angle";
  static constexpr std::array operand_sizes{3, 3, 3, 3, 1};
  static constexpr int constants = 0, rows = 1, entries = 13;
  static constexpr bool linear = false;

  template <class S>
  static void residual(const S* const* q, const S*, S* phi) {
    using std::cos;
    using std::sin;
    const auto s = vec::segment<3>(q[2], q[3]);
    phi[0] =
        cos(q[4][0]) * vec::dot<3>(q[1], s.data()) + sin(q[4][0]) * vec::dot<3>(q[0], s.data());
  }
  template <class S, class Entry>
  static void jacobian(const S* const* q, const S*, Entry&& entry) {
    using std::cos;
    using std::sin;
    const S cosine = cos(q[4][0]), sine = sin(q[4][0]);
    const auto s = vec::segment<3>(q[2], q[3]);
    for (int i = 0; i < 3; ++i) {
      const S along = cosine * q[1][i] + sine * q[0][i];
      entry(0, 0, i, sine * s[i]);
      entry(0, 1, i, cosine * s[i]);
      entry(0, 2, i, -along);
      entry(0, 3, i, along);
    }
    entry(0, 4, 0, cosine * vec::dot<3>(q[0], s.data()) - sine * vec::dot<3>(q[1], s.data()));
  }
  template <class S>
  static void quadratic(const S* const* q, const S* const* v, const S*, S* gamma) {
    using std::cos;
    using std::sin;
    const S cosine = cos(q[4][0]), sine = sin(q[4][0]), rate = v[4][0];
    const auto s = vec::segment<3>(q[2], q[3]);
    const auto w = vec::segment<3>(v[2], v[3]);
    // P = z·s and Q = x·s, so that Φ = cos φ P + sin φ Q.
    const S p = vec::dot<3>(q[1], s.data()),
            p_rate = vec::dot<3>(v[1], s.data()) + vec::dot<3>(q[1], w.data());
    const S r = vec::dot<3>(q[0], s.data()),
            r_rate = vec::dot<3>(v[0], s.data()) + vec::dot<3>(q[0], w.data());
    gamma[0] = S(2) * (cosine * vec::dot<3>(v[1], w.data()) + sine * vec::dot<3>(v[0], w.data())) +
               S(2) * rate * (cosine * r_rate - sine * p_rate) -
               rate * rate * (cosine * p + sine * r);
  }
};

/// Every kind there is: the one list that evaluation, recording and tests iterate. A constraint
/// stores its kind as a position in this list.
using ConstraintKinds =
    std::tuple<Length<2>, Length<3>, Unit<3>, Dot<3>, Projection<3>, Rigid<3, 0>, Rigid<3, 1>,
               Rigid<3, 2>, Rigid<3, 3>, Along<3>, Component<3, 2>, PlanarAngle, FrameAngle>;

inline constexpr int constraint_kind_count = std::tuple_size_v<ConstraintKinds>;

/// Position of Kind in ConstraintKinds.
template <class Kind>
constexpr int kind_index() {
  return []<std::size_t... I>(std::index_sequence<I...>) {
    int index = -1;
    ((std::is_same_v<Kind, std::tuple_element_t<I, ConstraintKinds>> ? (index = I) : 0), ...);
    return index;
  }
  (std::make_index_sequence<constraint_kind_count>{});
}

/// Calls f with a default-constructed tag of the kind at that position of ConstraintKinds.
template <class F>
void visit_kind(int kind, F&& f) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    ((kind == static_cast<int>(I) ? f(std::tuple_element_t<I, ConstraintKinds>{}) : void()), ...);
  }
  (std::make_index_sequence<constraint_kind_count>{});
}

}  // namespace desmo
