#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

namespace desmo {

/// Rest of a number that a double stands for: the number is the double + correction, within
/// radius.
struct Remainder {
  double correction = 0, radius = 0;
};

/// A number derived from numbers of the file, which count as exact: value + correction, within
/// radius but for the rounding of radii. Operations are those of Compensated<double>. They stand in
/// a source of their own, compiled without fused operations, so that every source may use them.
struct Derived {
  double value = 0, correction = 0, radius = 0;

  Derived() = default;
  Derived(double exact) : value(exact) {}
  Derived(double v, const Remainder& r) : value(v), correction(r.correction), radius(r.radius) {}

  static Derived pi() { return {0x1.921fb54442d18p1, {0x1.1a62633145c07p-53, 0x1p-108}}; }

  Remainder remainder() const { return {correction, radius}; }
  /// Returns the same number about another value, which is near.
  Derived about(double other) const;
  /// Returns the same number about the double nearest to it.
  Derived rounded() const { return about(value + correction); }

  friend Derived operator-(const Derived& a) { return {-a.value, {-a.correction, a.radius}}; }
  friend Derived operator+(const Derived& a, const Derived& b);
  friend Derived operator-(const Derived& a, const Derived& b) { return a + (-b); }
  friend Derived operator*(const Derived& a, const Derived& b);
  friend Derived operator/(const Derived& a, const Derived& b);
  friend Derived sqrt(const Derived& a);
  /// Returns the angle of the direction (x, y), which is not 0, about std::atan2 of the values.
  friend Derived atan2(const Derived& y, const Derived& x);
};

/// Returns a derived number in another scalar: the value, which formulations use. A wider one has
/// the correction, and one with a radius that, too.
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
