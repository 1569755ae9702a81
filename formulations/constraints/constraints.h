#pragma once

// The constraint kinds in natural and mixed coordinates (García de Jalón & Bayo), each written
// once and templated on the scalar: double evaluates, an extended type checks, a recording scalar
// yields the expression from which code is generated.
//
// A kind has
//   name            never changes: it is part of fingerprints of generated code
//   operand_sizes   components of each entity it joins, in order
//   constants       how many constants its functions take
//   rows            how many scalar equations it contributes
//   entries         how many partial derivatives its jacobian() emits
//   linear          true when all partial derivatives are constant; jacobian then reads no x
// and three functions in each EquationScalar, where x[k] points at the first component of operand
// k, v[k] at its velocity and c at the constants:
//   residual(x, c, phi)        phi[rows] = Φ, overwritten
//   jacobian(x, c, entry)      entry(row, operand, component, ∂Φ_row/∂x[operand][component]),
//                              always the same entries in the same order
//   quadratic(x, v, c, gamma)  gamma[rows] = Φ̇_q q̇, the quadratic velocity term of eq. (4),
//                              overwritten
// Kinds whose dimensions follow from the positions of their operands have a fourth function, in
// each MeasureScalar:
//   measure(x, c)              c[constants] = dimensions for which the constraint holds at x,
//                              overwritten; angles among the operands are not read
// Kinds without measure() take no constants, or constants that do not follow from the positions.
// The functions of a kind that reads a table take a cubic in place of the table: its piece at the
// present argument, which constants_at() finds. The operands of a constraint are different
// entities. Lengths are in the unit of the mechanism, angles in radians.

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "formulations/constraints/coordinates.h"
#include "formulations/constraints/joints.h"
#include "formulations/constraints/kinds.h"
#include "formulations/constraints/planar_angles.h"
#include "formulations/constraints/rigid_body.h"
#include "formulations/constraints/rotations.h"
#include "formulations/constraints/scalar_definitions.h"

namespace desmo {

namespace scalars {

using std::cos, std::sin, std::sqrt;

/// Operations of every scalar.
template <class S>
concept Scalar = std::default_initializable<S> && std::constructible_from<S, double> &&
    requires(S to, const S a) {
  to = -a;
  to = a + a;
  to = a - a;
  to = a * a;
};

/// Scalar of Φ, Φ_q and the quadratic velocity term. Jet is the shortest example.
template <class S>
concept EquationScalar = Scalar<S> && requires(S to, const S a) {
  to = sin(a);
  to = cos(a);
};

/// Scalar of measure().
template <class S>
concept MeasureScalar = Scalar<S> && requires(S to, const S a) {
  to = a / a;
  to = sqrt(a);
};

/// Scalar in which find_in_table() finds a piece. A scalar with a table_coefficient() of its own,
/// like Expr, need not be one.
template <class S>
concept TableScalar = Scalar<S> && requires(S to, const S a) {
  to = a / a;
  a < a;
  a <= a;
  a >= a;
  a != 0;
  static_cast<double>(a);
  static_cast<int>(a);
};

}  // namespace scalars

using scalars::EquationScalar, scalars::MeasureScalar, scalars::TableScalar;

/// List of all kinds, over which evaluation, recording and tests iterate. A constraint stores its
/// kind as a position in this list.
using ConstraintKinds = std::tuple<
    Length<2>, Length<3>, Unit<3>, Dot<3>, Projection<3>, Rigid<3, 0>, Rigid<3, 1>, Rigid<3, 2>,
    Rigid<3, 3>, Along<3>, Component<3, 2>, PlanarAngle, FrameAngle<-1, DirectionOf::line>, Unit<2>,
    Rigid<2, 0>, Rigid<2, 1>, Combination<3, 1>, Combination<3, 2>, Combination<3, 3>,
    Combination<3, 4>, PlanarRelation<PlanarTarget::point, DirectionOf::vector>,
    PlanarRelation<PlanarTarget::point, DirectionOf::line>,
    PlanarRelation<PlanarTarget::vector, DirectionOf::vector>,
    PlanarRelation<PlanarTarget::vector, DirectionOf::line>, Along<2>, Offset, Component<2, 0>,
    Component<2, 1>, Component<3, 0>, Component<3, 1>, Distance<2>, Distance<3>, PlanarDirection,
    PlanarTurn<Between::vector_and_vector>, PlanarTurn<Between::vector_and_line>,
    PlanarTurn<Between::line_and_vector>, PlanarTurn<Between::line_and_line>,
    PlanarTurn<Between::lines_at_point>, FrameAngle<-1, DirectionOf::vector>,
    FrameAngle<1, DirectionOf::line>, FrameAngle<1, DirectionOf::vector>, Reach<2>, Reach<3>,
    PlanarBearing<DirectionOf::vector>, PlanarBearing<DirectionOf::line>,
    PlanarBearingFrom<Between::vector_and_vector>, PlanarBearingFrom<Between::vector_and_line>,
    PlanarBearingFrom<Between::line_and_vector>, PlanarBearingFrom<Between::line_and_line>,
    PlanarBearingFrom<Between::lines_at_point>, Coupling<2>, Coupling<3>, Coupling<4>,
    TableCoupling, Dot<2>, Unit<4>, Turned<1>, Turned<-1>, Cross, EulerAxis<0>, EulerAxis<1>,
    EulerAxisOn<0>, EulerAxisOn<1>>;

inline constexpr int constraint_kind_count = std::tuple_size_v<ConstraintKinds>;

/// True for kinds that read a table; whole turns of their angles count.
template <class Kind>
inline constexpr bool has_table = requires {
  Kind::table;
};

/// Returns the constants c that the functions of a kind take at x. They are the numbers of a
/// constraint (Constraint::constants) themselves, except for kinds that read a table. The result
/// has data().
template <class Kind, class S>
auto constants_at(const S* numbers, const S* const* x) {
  if constexpr (has_table<Kind>)
    return Kind::about(numbers, x[1][0]);
  else
    return std::span<const S>(numbers, Kind::constants);
}

/// Returns the position of Kind in ConstraintKinds.
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
