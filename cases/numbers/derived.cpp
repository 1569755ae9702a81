#include "cases/numbers/derived.h"

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

Derived operator+(const Derived& a, const Derived& b) { return derived(Number(a) + Number(b)); }
Derived operator*(const Derived& a, const Derived& b) { return derived(Number(a) * Number(b)); }
Derived operator/(const Derived& a, const Derived& b) { return derived(Number(a) / Number(b)); }
Derived sqrt(const Derived& a) { return derived(sqrt(Number(a))); }

}  // namespace desmo
