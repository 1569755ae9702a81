#pragma once

#include "formulations/equations/elementary.h"

namespace desmo::elementary {

/// An angle with its sine and cosine, evaluated at that very number.
template <class T>
struct TurnedAngle {
  T angle, sine, cosine;
};

/// The largest tangent of a small turn.
inline constexpr double small_turn = 1.0 / 8;

/// The angle of (x, y) from the x axis that is nearest to `before`, by the turn from there: sine
/// and cosine of `before` do not wait for x and y, and those of a small turn are short. All
/// interpolated at zeros of Chebyshev polynomials, errors below 1e-17. Not a number at the origin,
/// and where `before` is beyond ±largest_reduced.
template <class T>
DESMO_INLINE TurnedAngle<T> turned_angle(const T& y, const T& x, const T& before) {
  using std::abs;
  const auto [s, c] = sine_cosine(before);
  const T across = y * c - x * s, along = x * c + y * s;
  if (!all(abs(across) < small_turn * along)) [[unlikely]] {
    const T angle = before + arctan(across, along);
    const auto [sine, cosine] = sine_cosine(angle);
    return {angle, sine, cosine};
  }
  constexpr std::array arctangent{-0.33333333333333287, 0.19999999999790477,  -0.14285714129116034,
                                  0.1111106826170422,   -0.09085599506798686, 0.07387718384425714};
  const T z = across / along, zz = z * z;
  const T angle = before + (z + (z * zz) * polynomial(arctangent, zz));
  constexpr std::array sine{-1.0 / 6, 0.008333333333310013, -0.0001984126908903399,
                            2.754955400606849e-06};
  constexpr std::array cosine{0.0416666666666346, -0.0013888888516528704, 2.4795180967871062e-05};
  const T turn = angle - before, tt = turn * turn;  // as rounding left it
  const T st = turn + (turn * tt) * polynomial(sine, tt);
  const T ct = (1.0 - 0.5 * tt) + (tt * tt) * polynomial(cosine, tt);
  return {angle, s * ct + c * st, c * ct - s * st};
}

}  // namespace desmo::elementary
