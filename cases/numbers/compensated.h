#pragma once

#include <cmath>

#include "cases/numbers/derived.h"
#include "cases/numbers/interval.h"
#include "cases/numbers/turn.h"

namespace desmo {

/// A number in compensated arithmetic: value + correction, with an error of at most `radius`,
/// except for the rounding of radii, which enclosure() adds. The correction takes up what each
/// operation rounds off. So the radius of a result from exact operands is of the second order in
/// the unit roundoff (Ogita, Rump & Oishi, SIAM J. Sci. Comput. 26, 2005). It suits residuals,
/// where all leading digits cancel. S: double, or LaneNumbers for four numbers.
///
/// Assumptions: IEEE arithmetic rounded to nearest; no operation is contracted to fma() by the
/// compiler; for angles above 2^21 rad, those of library_turn().
template <class S>
struct Compensated {
  S value{0}, correction{0}, radius{0};

  Compensated() = default;
  Compensated(double exact) : value(exact) {}
  Compensated(const S& v, const S& c, const S& r) : value(v), correction(c), radius(r) {}
  explicit Compensated(const Derived& x)
      : value(x.value), correction(x.correction), radius(x.radius) {}

  friend Compensated operator-(const Compensated& a) { return {-a.value, -a.correction, a.radius}; }
  friend Compensated operator-(const Compensated& a, const Compensated& b) { return a + (-b); }
  friend Compensated operator+(const Compensated& a, const Compensated& b) {
    const S sum = a.value + b.value;
    const S of_b = sum - a.value;
    const S remainder = (a.value - (sum - of_b)) + (b.value - of_b);  // exact: what `sum` lost
    const S before = a.correction + b.correction;
    const S correction = before + remainder;
    return {sum, correction, bound(a.radius + b.radius, size(before) + size(correction))};
  }
  friend Compensated operator*(const Compensated& a, const Compensated& b) {
    using std::fma;
    const S product = a.value * b.value;
    const S remainder = fma(a.value, b.value, -product);  // exact: what `product` lost
    const S half = fma(b.value, a.correction, remainder);
    const S correction = fma(a.value, b.correction, half);
    const S of_a = size(a.correction) + a.radius, of_b = size(b.correction) + b.radius;
    const S first = fma(size(a.value), b.radius, size(b.value) * a.radius);
    return {product, correction, bound(fma(of_a, of_b, first), size(half) + size(correction))};
  }
  friend Compensated operator/(const Compensated& a, const Compensated& b) {
    const S value = a.value / b.value;
    return quotient(value, a - Compensated(value, 0, 0) * b, b.value,
                    (size(b.correction) + b.radius) / size(b.value));
  }
  friend Compensated sqrt(const Compensated& a) {
    using std::sqrt;
    // √a = v + R/(v + √a) with R = a − v², and v + √a differs from 2 v by at most |R|/v.
    const S value = sqrt(a.value);
    const Compensated root(value, 0, 0), rest = a - root * root;
    const S far = size(rest.value + rest.correction) + rest.radius;
    return quotient(value, rest, 2 * value, far / (2 * a.value));
  }
  friend Compensated sin(const Compensated& a) {
    const Turn<S> at = turn(a.value);
    return turned(a, at.sine, at.of_sine, at.cosine, at.off);
  }
  friend Compensated cos(const Compensated& a) {
    const Turn<S> at = turn(a.value);
    return turned(a, at.cosine, at.of_cosine, -at.sine, at.off);
  }
  /// Adds factor × x to this number, where x is exact.
  void add_product(const Compensated& factor, const S& x) {
    using std::fma;
    const S product = factor.value * x;
    const S remainder = fma(factor.correction, x, fma(factor.value, x, -product));
    const S sum = value + product;
    const S of_product = sum - value;
    const S second = remainder + ((value - (sum - of_product)) + (product - of_product));
    value = sum;
    correction = correction + second;
    radius = bound(fma(factor.radius, size(x), radius),
                   size(remainder) + size(second) + size(correction));
  }
  /// Returns an interval that holds the number.
  BasicInterval<S> enclosure() const {
    // A radius is a sum of products that are not negative. The factor covers 2^13 roundings in a
    // row, each of a relative 2^-53. Radii do not count what underflow takes off a product, less
    // than 2^-1072. The sum of intervals adds 2^-500 (BasicInterval::tiny), which covers it as long
    // as later factors stay below 2^500 in all.
    constexpr double up = 1 + 0x1p-40;
    return BasicInterval<S>(value, radius * S(up)) + BasicInterval<S>(correction, S(0));
  }
  /// Returns an upper bound of the number's magnitude.
  S magnitude() const { return enclosure().magnitude(); }
  /// Compares values without their corrections: splines find the interval of a time in this way.
  friend bool operator<(const Compensated& a, const Compensated& b) { return a.value < b.value; }

 private:
  static constexpr double unit = 0x1p-53;

  static S size(const S& x) {
    using std::abs;
    return abs(x);
  }
  /// Returns radius + 2^-53 · rounded, itself rounded to nearest.
  /// - rounded: sum of the magnitudes of all rounded results
  static S bound(const S& radius, const S& rounded) {
    using std::fma;
    return fma(S(unit), rounded, radius);
  }

  /// Returns value + rest/d for every d with |d − divisor| ≤ relative · |divisor|. The relative
  /// error of 1/divisor is then at most relative / (1 − relative). The radius is infinite unless
  /// relative < 1/2.
  static Compensated quotient(const S& value, const Compensated& rest, const S& divisor,
                              const S& relative) {
    constexpr double half = 0.5;
    const S sum = rest.value + rest.correction;
    const S correction = sum / divisor;
    const S rounded = (rest.radius + S(unit) * size(sum)) / size(divisor);
    const S radius = (rounded + size(correction) * (relative + S(unit))) / (S(1) - relative);
    return {value, correction, relative < half ? radius : S(INFINITY)};
  }

  /// Returns f(a), where f is sine or cosine and a an angle [rad], from f(a.value).
  /// - value + remainder: f(a.value), with an error of at most `off`
  /// - slope: f′(a.value), rounded to double
  static Compensated turned(const Compensated& a, const S& value, const S& remainder,
                            const S& slope, const S& off) {
    // f(a + e) = f(a) + f′(a) e + f″(ξ) e²/2 with |f″| ≤ 1
    const S first = slope * a.correction;
    const S correction = remainder + first;
    const S e = size(a.correction) + a.radius;
    // The radius has e², twice the bound on the second-order term. The other e²/2 covers the
    // roundings of `first` and of the sum with it, together ≤ 2^-51 e, where e ≥ 2^-50. For smaller
    // e the margin of `off`, by which it exceeds the error of f(a.value), covers them.
    return {value, correction, off + size(slope) * a.radius + e * e};
  }
};

}  // namespace desmo
