#pragma once

#include <array>
#include <functional>
#include <type_traits>

#include "cases/numbers/compensated.h"
#include "cases/numbers/derived.h"
#include "cases/numbers/interval.h"
#include "formulations/constraints/constraints.h"
#include "formulations/constraints/jet.h"
#include "formulations/verification/certificate/lane_numbers.h"
#include "formulations/verification/certificate/taylor_model.h"

namespace desmo {

/// Function that returns number k of a table (formulations/constraints/table.h) as the file means
/// it.
using TableNumbers = std::function<Derived(int k)>;

/// The pieces of a table as the file means them.
struct TablePieces {
  const TableNumbers& number;
  int count = static_cast<int>(number(0).value);
  bool repeats = number(1).value != 0;
  Derived length = number(3 + count) - number(3);

  /// Returns a knot, `turns` lengths of the table on, minus an argument.
  Derived distance(int knot, double turns, double at) const {
    return number(3 + knot) + length * turns - at;
  }
  /// Returns the coefficients of a piece, `turns` lengths on, as a polynomial about an argument.
  std::array<Derived, 4> about(int piece, double turns, double at) const;
};

/// Encloses a table f by Taylor's coefficients a₀ … a₃ about `at`. For each |y| ≤ distance, some
/// numbers within the radii of the aₖ give f(at + y) = Σ aₖ yᵏ. Other numbers within them give f′
/// and f″ there. Radii cover the neighbouring pieces within the distance. All aₖ are NaN where `at`
/// is outside of the table. Radii are infinite where the distance leads out of the table
/// (table_margin), is not finite, or has too many knots in it.
std::array<Derived, 4> enclose_table(const TableNumbers& number, double at, double distance);

// Access to the scalars of proofs. lead() returns the leading double. in_lane() reads the number in
// a lane, set_lane() sets it. A double has one lane.

inline double in_lane(double x, int) { return x; }
inline double in_lane(const LaneNumbers& x, int lane) { return x[lane]; }
inline void set_lane(double& x, int, double to) { x = to; }
inline void set_lane(LaneNumbers& x, int lane, double to) { x.set(lane, to); }

template <class S>
const S& lead(const Compensated<S>& x) {
  return x.value;
}
template <class S>
const S& lead(const BasicInterval<S>& x) {
  return x.mid;
}
template <class S, int D>
const S& lead(const TaylorModel<S, D>& x) {
  return x.c[0];
}

/// Returns a bound on |x − x.value|. The factor covers the rounding of radii.
template <class S>
S rest_of(const Compensated<S>& x) {
  using std::abs;
  return (abs(x.correction) + x.radius) * (1 + 0x1p-40);
}
inline double rest_of(const Derived& x) { return rest_of(Compensated<double>(x)); }
template <class S>
void set_lane(Compensated<S>& x, int lane, const Derived& to) {
  set_lane(x.value, lane, to.value);
  set_lane(x.correction, lane, to.correction);
  set_lane(x.radius, lane, to.radius);
}
template <class S>
void set_lane(BasicInterval<S>& x, int lane, const Derived& to) {
  set_lane(x.mid, lane, to.value);
  set_lane(x.radius, lane, rest_of(to));
}
template <class S, int D>
void set_lane(TaylorModel<S, D>& x, int lane, const Derived& to) {
  set_lane(x.c[0], lane, to.value);
  set_lane(x.rest, lane, rest_of(to));
}
template <class S>
void set_lane(Jet<S>& x, int lane, const Derived& to) {
  set_lane(x.value, lane, to);
}

template <class S>
const S& value_of(const S& x) {
  return x;
}
template <class S>
const S& value_of(const Jet<S>& x) {
  return x.value;
}

/// Sets the constants c that the functions of TableCoupling take at positions x, in any scalar of
/// proofs. In place of the table, c has its argument ξ and an enclosure of the cubic about ξ.
/// c[0 … 2]: set already. number(lane, k): returns number k of the constraint in a lane
template <class S, class Number>
void set_table_constants(S* c, const S* const* x, const Number& number) {
  const auto argument = value_of(c[1]) * value_of(x[1][0]);
  const auto& at = lead(argument);
  constexpr int lanes =
      std::is_same_v<std::decay_t<decltype(at)>, double> ? 1 : int{LaneNumbers::count};
  std::decay_t<decltype(argument)> centre;
  for (int lane = 0; lane < lanes; ++lane) set_lane(centre, lane, Derived(in_lane(at, lane)));
  const auto distance = (argument - centre).magnitude();
  c[3] = centre;
  for (int lane = 0; lane < lanes; ++lane) {
    const std::array<Derived, 4> a =
        enclose_table([&](int k) { return number(lane, TableCoupling::table + k); },
                      in_lane(at, lane), in_lane(distance, lane));
    for (int k = 0; k < 4; ++k) set_lane(c[4 + k], lane, a[k]);
  }
}

}  // namespace desmo
