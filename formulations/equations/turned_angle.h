#pragma once

#include "formulations/equations/elementary.h"

namespace desmo::elementary {

/// An angle with its sine and cosine, evaluated at exactly that number.
template <class T>
struct TurnedAngle {
  T angle, sine, cosine;
};

/// Limit of |tangent| of a small turn from an anchor (<).
inline constexpr double small_turn = 1.0 / 4;
/// Limit of the distance between the previous angle and its anchor [rad] (<). Below it, and after a
/// small turn from the anchor, the angle nearest to the anchor is also nearest to the previous one.
inline constexpr double near_anchor = 1.0 / 2;

/// Returns the angle of (x, y) from the x axis, whole turns chosen so that it is nearest to
/// `before`. Where `before` is near the anchor (see ExplicitBinding) and the turn from the anchor
/// is small, short polynomials suffice. Elsewhere everything is evaluated, and the result becomes
/// the new anchor. Polynomials interpolate at zeros of Chebyshev polynomials; errors are below
/// 1e-17. Returns NaN at the origin, and where everything is evaluated for a `before` at or beyond
/// ±max_reduced.
template <class T>
DESMO_INLINE TurnedAngle<T> turned_angle(const T& y, const T& x, const T& before, T* anchor) {
  using std::abs;
  const T from = anchor[0], s = anchor[1], c = anchor[2];
  const T across = y * c - x * s, along = x * c + y * s;
  const Mask<T> is_near = (abs(across) < small_turn * along) & (abs(before - from) < near_anchor);
  if (!all(is_near)) [[unlikely]] {
    const auto [sine_before, cosine_before] = sine_cosine(before);
    const T angle = before + arctan<T>(y * cosine_before - x * sine_before,
                                       x * cosine_before + y * sine_before);
    const auto [sine, cosine] = sine_cosine(angle);
    anchor[0] = angle, anchor[1] = sine, anchor[2] = cosine;
    return {angle, sine, cosine};
  }
  constexpr std::array arctangent{-0.33333333333333304, 0.19999999999938586,  -0.14285714265033303,
                                  0.11111108452369065,  -0.09090740742952762, 0.07686491336172022,
                                  -0.06554306272128751, 0.047262582468376946};
  const T z = across / along, zz = z * z;
  const T angle = from + (z + (z * zz) * polynomial(arctangent, zz));
  constexpr std::array sine{-1.0 / 6, 0.008333333333333129, -0.00019841269838548155,
                            2.7557306543077704e-06, -2.5027990890027887e-08};
  constexpr std::array cosine{0.041666666666666456, -0.0013888888887756633, 2.4801577881306293e-05,
                              -2.7532236752638345e-07};
  const T turn = angle - from, tt = turn * turn;  // the turn to the rounded angle
  const T st = turn + (turn * tt) * polynomial(sine, tt);
  const T ct = (1.0 - 0.5 * tt) + (tt * tt) * polynomial(cosine, tt);
  return {angle, s * ct + c * st, c * ct - s * st};
}

}  // namespace desmo::elementary
