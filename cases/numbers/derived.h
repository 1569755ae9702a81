#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

namespace desmo {

/// Difference between a number and the double that stands for it: |number − (double + correction)|
/// ≤ radius.
struct Remainder {
  double correction = 0, radius = 0;
};

/// A number derived from numbers of a file, which count as exact: value + correction, with an error
/// of at most `radius`, except for the rounding of radii. Operations are those of
/// Compensated<double>. They stand in a source of their own, compiled without fused operations, so
/// that every source may use them.
struct Derived {
  double value = 0, correction = 0, radius = 0;

  Derived() = default;
  Derived(double exact) : value(exact) {}
  Derived(double v, const Remainder& r) : value(v), correction(r.correction), radius(r.radius) {}

  static Derived pi() { return {0x1.921fb54442d18p1, {0x1.1a62633145c07p-53, 0x1p-108}}; }

  Remainder remainder() const { return {correction, radius}; }
  /// Returns the same number with `other` as its value: the difference becomes the correction, and
  /// its rounding is added to the radius.
  Derived about(double other) const;
  /// Returns the same number with the double nearest to value + correction as its value.
  Derived rounded() const { return about(value + correction); }
  /// Returns the number times 2^exponent. This is exact unless a member overflows or underflows.
  Derived scaled(int exponent) const;

  friend Derived operator-(const Derived& a) { return {-a.value, {-a.correction, a.radius}}; }
  friend Derived operator+(const Derived& a, const Derived& b);
  friend Derived operator-(const Derived& a, const Derived& b) { return a + (-b); }
  friend Derived operator*(const Derived& a, const Derived& b);
  friend Derived operator/(const Derived& a, const Derived& b);
  friend Derived sqrt(const Derived& a);
  friend Derived sin(const Derived& a);
  friend Derived cos(const Derived& a);
  /// Returns the angle of the direction (x, y) [rad]; its value is std::atan2 of the values. The
  /// values of x and y must not both be 0.
  friend Derived atan2(const Derived& y, const Derived& x);
};

/// Returns a derived number in another scalar S.
/// - S made from a Derived, such as Compensated: value, correction and radius
/// - S with more digits than double: value + correction
/// - any other, as formulations use it: the value alone
template <class S>
S as(const Derived& x) {
  if constexpr (std::is_constructible_v<S, const Derived&>)
    return S(x);
  else if constexpr (std::numeric_limits<S>::digits > std::numeric_limits<double>::digits)
    return S(x.value) + S(x.correction);
  else
    return S(x.value);
}

}  // namespace desmo
