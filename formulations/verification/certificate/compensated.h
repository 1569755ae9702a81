#pragma once

#include <cfloat>
#include <cmath>
#include <type_traits>

#include "formulations/verification/certificate/lanes.h"

namespace desmo {

/// A number in compensated arithmetic: value + correction, with an error of at most `radius`. The
/// correction takes up what each operation rounds off, so the radius is of the second order in the
/// unit roundoff (Ogita, Rump & Oishi, SIAM J. Sci. Comput. 26, 2005). It suits residuals, where
/// all leading digits cancel. S: double, or Lanes for four numbers.
///
/// What is assumed: as for intervals; sine and cosine of `long double` within one unit in its last
/// place.
template <class S>
struct Compensated {
  S value{0}, correction{0}, radius{0};

  Compensated() = default;
  Compensated(double exact) : value(exact) {}
  Compensated(const S& v, const S& c, const S& r) : value(v), correction(c), radius(r) {}

  friend Compensated operator-(const Compensated& a) { return {-a.value, -a.correction, a.radius}; }
  friend Compensated operator-(const Compensated& a, const Compensated& b) { return a + (-b); }
  friend Compensated operator+(const Compensated& a, const Compensated& b) {
    const S sum = a.value + b.value;
    const S of_b = sum - a.value;
    const S rest = (a.value - (sum - of_b)) + (b.value - of_b);  // exact (Knuth)
    const S before = a.correction + b.correction;
    const S correction = before + rest;
    return {sum, correction, bound(a.radius + b.radius, size(before) + size(correction))};
  }
  friend Compensated operator*(const Compensated& a, const Compensated& b) {
    using std::fma;
    const S product = a.value * b.value;
    const S rest = fma(a.value, b.value, -product);  // exact
    const S half = fma(b.value, a.correction, rest);
    const S correction = fma(a.value, b.correction, half);
    const S of_a = size(a.correction) + a.radius, of_b = size(b.correction) + b.radius;
    return {product, correction,
            bound(size(a.value) * b.radius + size(b.value) * a.radius + of_a * of_b,
                  size(half) + size(correction))};
  }
  friend Compensated sin(const Compensated& a) {
    const auto [sine, rest] = split([](long double x) { return std::sin(x); }, a.value);
    return turned(a, sine, rest, split([](long double x) { return std::cos(x); }, a.value).value);
  }
  friend Compensated cos(const Compensated& a) {
    const auto [cosine, rest] = split([](long double x) { return std::cos(x); }, a.value);
    return turned(a, cosine, rest,
                  -split([](long double x) { return std::sin(x); }, a.value).value);
  }
  /// Compares leading digits: the order of points, which splines look up.
  friend bool operator<(const Compensated& a, const Compensated& b) { return a.value < b.value; }

 private:
  static constexpr double unit = 0x1p-53, tiny = 0x1p-500, above = 1 + 16 * unit;

  static S size(const S& x) {
    using std::abs;
    return abs(x);
  }
  /// Returns a radius, rounded up. rounded: sum of the numbers that were rounded.
  static S bound(const S& radius, const S& rounded) {
    return (radius + S(unit) * rounded) * S(above) + S(tiny);
  }

  struct Split {
    S value, rest;
  };
  /// Returns a function in extended precision, as two numbers.
  template <class Function>
  static Split split(Function&& function, const S& x) {
    if constexpr (std::is_same_v<S, double>) {
      const long double y = function(static_cast<long double>(x));
      const double value = static_cast<double>(y);
      return {value, static_cast<double>(y - value)};
    } else {
      Split all;
      for (int lane = 0; lane < S::count; ++lane) {
        const auto [value, rest] = Compensated<double>::split(function, x[lane]);
        all.value.set(lane, value);
        all.rest.set(lane, rest);
      }
      return all;
    }
  }
  /// Returns a sine or cosine from its two numbers and its slope, rounded to double, at the value.
  static Compensated turned(const Compensated& a, const S& value, const S& rest, const S& slope) {
    // f(a + e) = f(a) + f′(a) e + f″(ξ) e²/2 with |f″| ≤ 1
    constexpr double last_place = LDBL_EPSILON;  // of numbers up to 1
    const S first = slope * a.correction;
    const S correction = rest + first;
    const S e = size(a.correction) + a.radius;
    return {value, correction,
            bound(S(last_place) + (size(slope) + S(unit)) * a.radius + S(0.5) * (e * e),
                  S(2) * size(first) + size(correction))};
  }
  template <class>
  friend struct Compensated;
};

}  // namespace desmo
