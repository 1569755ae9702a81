#pragma once

#include <cmath>
#include <numbers>

#include "formulations/equations/explicit_kernel.h"

// Functions of angles for generated code, for double and for lanes of doubles: short enough to be
// inlined, without branches but for arguments far away, within 2 units in the last place of those
// of the standard library.

// A call would cost the registers of straight-line code around it.
#define DESMO_INLINE [[gnu::always_inline]] inline

namespace desmo::elementary {

/// mask ? a : b
template <class T>
DESMO_INLINE T select(const Mask<T>& mask, const T& a, const T& b) {
  if constexpr (std::is_same_v<Mask<T>, bool>) {
    return mask ? a : b;
  } else {
    T result = b;
    where(mask, result) = a;
    return result;
  }
}

/// f of each value.
template <class T>
T each(double (*f)(double), const T& x) {
  if constexpr (std::is_same_v<T, double>)
    return f(x);
  else
    return T([&](auto lane) { return f(x[lane]); });
}

/// Where the reduction of an angle keeps its accuracy.
inline constexpr double largest_reduced = 1e6;

/// Taylor's series; the first term left out is below 1e-19 of the sum.
template <class T>
DESMO_INLINE T sine_near_zero(const T& x) {
  const T u = x * x;
  T s = u * (1.0 / 355687428096000) - 1.0 / 1307674368000;  // 1/17! and so on
  s = s * u + 1.0 / 6227020800;
  s = s * u - 1.0 / 39916800;
  s = s * u + 1.0 / 362880;
  s = s * u - 1.0 / 5040;
  s = s * u + 1.0 / 120;
  s = s * u - 1.0 / 6;
  return x + x * (u * s);
}
template <class T>
DESMO_INLINE T cosine_near_zero(const T& x) {
  const T u = x * x;
  T s = u * (1.0 / 20922789888000) - 1.0 / 87178291200;  // 1/16! and so on
  s = s * u + 1.0 / 479001600;
  s = s * u - 1.0 / 3628800;
  s = s * u + 1.0 / 40320;
  s = s * u - 1.0 / 720;
  s = s * u + 1.0 / 24;
  s = s * u - 0.5;
  return 1.0 + u * s;
}

template <class T>
struct SineCosine {
  T sine, cosine;
};

/// Both at once: asked for both of one angle, a compiler computes what they share once.
template <class T>
DESMO_INLINE SineCosine<T> sine_cosine(const T& x) {
  using std::abs, std::floor, std::nearbyint;
  if (!all(abs(x) < largest_reduced))  // or not a number
    return {each<T>(&std::sin, x), each<T>(&std::cos, x)};
  // Quarter turns, and what remains, within ±π/4: π/2 in three parts, of which the first two leave
  // room for the product with the quarters.
  constexpr double first = 0x1.921fb544p+0, second = 0x1.0b4611a6p-34,
                   third = 0x1.3198a2e037073p-69;
  const T n = nearbyint(x * (2 / std::numbers::pi));
  const T rest = ((x - n * first) - n * second) - n * third;
  const T s = sine_near_zero(rest), c = cosine_near_zero(rest);
  const T half = floor(0.5 * n), odd = n - 2.0 * half;  // odd: 0 or 1
  const T sign = 1.0 - 2.0 * (half - 2.0 * floor(0.5 * half));
  return {sign * select<T>(odd > 0.0, c, s),
          (sign - 2.0 * (odd * sign)) * select<T>(odd > 0.0, s, c)};
}

template <class T>
DESMO_INLINE T sin(const T& x) {
  return sine_cosine(x).sine;
}
template <class T>
DESMO_INLINE T cos(const T& x) {
  return sine_cosine(x).cosine;
}

/// arctan of |z| ≤ tan(π/8): interpolated at the zeros of a Chebyshev polynomial of z², error
/// 3e-18.
template <class T>
DESMO_INLINE T arctan_near_zero(const T& z) {
  const T u = z * z;
  T s = u * -0.017805382196606493 + 0.03796524391097195;
  s = s * u - 0.05035101930016078;
  s = s * u + 0.05846878181892052;
  s = s * u - 0.06662951797955637;
  s = s * u + 0.07692045329539092;
  s = s * u - 0.09090896808988135;
  s = s * u + 0.11111110744917034;
  s = s * u - 0.14285714279250192;
  s = s * u + 0.1999999999994089;
  s = s * u - 0.3333333333333312;
  return z + z * (u * s);
}

/// The angle of (x, y) from the x axis, within ±π; not a number at the origin.
template <class T>
DESMO_INLINE T arctan(const T& y, const T& x) {
  using std::abs, std::copysign;
  constexpr double pi = std::numbers::pi, tan_eighth = std::numbers::sqrt2 - 1;  // tan(π/8)
  const T zero = 0.0, ax = abs(x), ay = abs(y);
  const T low = select<T>(ax < ay, ax, ay), high = select<T>(ax < ay, ay, ax);
  const auto steep = low > tan_eighth * high;  // then from the diagonal
  const T z = select<T>(steep, low - high, low) / select<T>(steep, low + high, high);
  T angle = arctan_near_zero(z) + select<T>(steep, zero + pi / 4, zero);
  angle = select<T>(ay > ax, pi / 2 - angle, angle);
  angle = select<T>(x < zero, pi - angle, angle);
  return copysign(angle, y);
}

/// The angle of (x, y) from the x axis that is nearest to `before`.
template <class T>
DESMO_INLINE T angle_near(const T& y, const T& x, const T& before) {
  using std::nearbyint;
  constexpr double turn = 2 * std::numbers::pi;
  const T angle = arctan(y, x);
  return angle + turn * nearbyint((before - angle) * (1 / turn));
}

}  // namespace desmo::elementary

#undef DESMO_INLINE
