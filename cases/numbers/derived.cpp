#include "cases/numbers/derived.h"

#include <algorithm>
#include <cmath>

#include "cases/numbers/compensated.h"

namespace desmo {

namespace {

using Number = Compensated<double>;

Derived derived(const Number& x) { return {x.value, {x.correction, x.radius}}; }

}  // namespace

Derived Derived::about(double other) const {
  if (other == value) return *this;
  const Interval rest = (Number(*this) - Number(other)).enclosure();
  return {other, {rest.mid, rest.radius}};
}

Derived Derived::scaled(int exponent) const {
  return {std::ldexp(value, exponent),
          {std::ldexp(correction, exponent), std::ldexp(radius, exponent)}};
}

Derived operator+(const Derived& a, const Derived& b) { return derived(Number(a) + Number(b)); }
Derived operator*(const Derived& a, const Derived& b) { return derived(Number(a) * Number(b)); }
Derived operator/(const Derived& a, const Derived& b) { return derived(Number(a) / Number(b)); }
Derived sqrt(const Derived& a) {
  const bool is_zero = a.value == 0 && a.correction == 0 && a.radius == 0;
  return is_zero ? a : derived(sqrt(Number(a)));
}
Derived sin(const Derived& a) { return derived(sin(Number(a))); }
Derived cos(const Derived& a) { return derived(cos(Number(a))); }

Derived atan2(const Derived& y, const Derived& x) {
  const double angle = std::atan2(y.value, x.value);
  const int exponent = std::ilogb(std::max(std::abs(y.value), std::abs(x.value)));
  // Scaled in this way, no square overflows or vanishes.
  const Derived v = y.scaled(-exponent), u = x.scaled(-exponent);
  // The remainder of `angle` is the angle from its direction to (x, y), whose sine is `sine`. A
  // small angle differs from its sine by less than |sine|³/5.
  const Derived at_sine = derived(sin(Number(angle))), at_cosine = derived(cos(Number(angle)));
  Derived sine = (v * at_cosine - u * at_sine) / sqrt(u * u + v * v);
  sine.radius += std::pow(std::abs(sine.value + sine.correction) + sine.radius, 3) / 5;
  return (Derived(angle) + sine).about(angle);
}

}  // namespace desmo
