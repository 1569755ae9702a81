#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "formulations/equations/explicit_kernel.h"

// Functions of angles for generated code, for double and for lanes of doubles. They are short
// enough to be inlined, and within 2 units in the last place of the standard library's.

// Inlines always: a call would spill the registers of the straight-line code around it.
#define DESMO_INLINE [[gnu::always_inline]] inline

namespace desmo::elementary {

/// Returns mask ? a : b.
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

/// Limit of |angle| [rad] (<) below which its reduction to ±π/2 is accurate.
inline constexpr double max_reduced = 1e6;

/// Returns Σ c[i] xⁱ, summed in pairs. That is about as much work as Horner's rule, at less than
/// half its latency.
template <class C, std::size_t n, class T>
DESMO_INLINE T polynomial(const std::array<C, n>& c, const T& x) {
  if constexpr (n == 1) {
    return c[0];
  } else {
    std::array<T, (n + 1) / 2> pairs;
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      ((pairs[i] = c[2 * i + 1] * x + c[2 * i]), ...);
    }
    (std::make_index_sequence<n / 2>());
    if constexpr (n % 2 == 1) pairs[n / 2] = c[n - 1];
    return polynomial(pairs, T(x * x));
  }
}

/// Returns sin x for |x| ≤ π/2, interpolated at the zeros of a Chebyshev polynomial of x². The
/// error before rounding is below 4e-17.
template <class T>
DESMO_INLINE T sine_near_zero(const T& x) {
  constexpr std::array c{-1.0 / 6,
                         0.008333333333333316,
                         -0.00019841269841254974,
                         2.7557319219163234e-06,
                         -2.5052107616996175e-08,
                         1.6058977312463691e-10,
                         -7.643970296785917e-13,
                         2.731444766828598e-15};
  const T u = x * x;
  return x + (x * u) * polynomial(c, u);
}
/// Returns cos x for |x| ≤ π/2, likewise.
template <class T>
DESMO_INLINE T cosine_near_zero(const T& x) {
  constexpr std::array c{0.04166666666666634,     -0.0013888888888860709, 2.4801587292446213e-05,
                         -2.7557317767320517e-07, 2.0876630867422246e-09, -1.1464689885696053e-11,
                         4.627675984719231e-14};
  const T u = x * x;
  return (1.0 - 0.5 * u) + (u * u) * polynomial(c, u);
}

template <class T>
struct SineCosine {
  T sine, cosine;
};

/// Returns sine and cosine of an angle [rad], NaN at and beyond ±max_reduced. Where code calls
/// sin() and cos() of one angle, the compiler evaluates their common part once.
template <class T>
DESMO_INLINE SineCosine<T> sine_cosine(const T& far_or_near) {
  using std::abs, std::floor, std::nearbyint;
  const T none = std::numeric_limits<double>::quiet_NaN();
  const T x = select<T>(abs(far_or_near) < max_reduced, far_or_near, none);
  // Takes n half turns off, which leaves `rest` within ±π/2. π is split in three parts: the
  // products of n with the first two are exact.
  constexpr double first = 0x1.921fb544p+1, second = 0x1.0b4611a6p-33,
                   third = 0x1.3198a2e037073p-68;
  const T n = nearbyint(x * (1 / std::numbers::pi));
  const T rest = ((x - n * first) - n * second) - n * third;
  const T sign = (1.0 + 4.0 * floor(0.5 * n)) - 2.0 * n;  // −1 where n is odd
  return {sign * sine_near_zero(rest), sign * cosine_near_zero(rest)};
}

template <class T>
DESMO_INLINE T sin(const T& x) {
  return sine_cosine(x).sine;
}
template <class T>
DESMO_INLINE T cos(const T& x) {
  return sine_cosine(x).cosine;
}

/// Returns arctan z for |z| ≤ tan(π/8), interpolated at the zeros of a Chebyshev polynomial of z².
/// The error before rounding is below 2e-18.
template <class T>
DESMO_INLINE T arctan_near_zero(const T& z) {
  constexpr std::array c{-0.3333333333333312,  0.1999999999994089,   -0.14285714279250192,
                         0.11111110744917034,  -0.09090896808988135, 0.07692045329539092,
                         -0.06662951797955637, 0.05846878181892052,  -0.05035101930016078,
                         0.03796524391097195,  -0.017805382196606493};
  const T u = z * z;
  return z + (z * u) * polynomial(c, u);
}

/// Returns the angle of (x, y) from the x axis, within ±π; NaN at the origin.
template <class T>
DESMO_INLINE T arctan(const T& y, const T& x) {
  using std::abs, std::copysign;
  constexpr double pi = std::numbers::pi, tan_eighth = std::numbers::sqrt2 - 1;  // tan(π/8)
  const T zero = 0.0, ax = abs(x), ay = abs(y);
  const T low = select<T>(ax < ay, ax, ay), high = select<T>(ax < ay, ay, ax);
  const auto steep = low > tan_eighth * high;  // then measured from the diagonal
  const T z = select<T>(steep, low - high, low) / select<T>(steep, low + high, high);
  T angle = arctan_near_zero(z) + select<T>(steep, zero + pi / 4, zero);
  angle = select<T>(ay > ax, pi / 2 - angle, angle);
  angle = select<T>(x < zero, pi - angle, angle);
  return copysign(angle, y);
}

}  // namespace desmo::elementary
