#pragma once

#include <cmath>

namespace desmo::exact {

using Real = long double;

/// A function of time at one instant: value and first two time derivatives. Formulas written for
/// positions yield velocities and accelerations as well.
struct Jet {
  Real v = 0, d = 0, dd = 0;

  constexpr Jet() = default;
  constexpr Jet(Real value) : v(value) {}  // a constant
  constexpr Jet(Real value, Real rate, Real second) : v(value), d(rate), dd(second) {}

  static Jet time(Real t) { return {t, 1, 0}; }
};

inline Jet operator-(Jet a) { return {-a.v, -a.d, -a.dd}; }
inline Jet operator+(Jet a, Jet b) { return {a.v + b.v, a.d + b.d, a.dd + b.dd}; }
inline Jet operator-(Jet a, Jet b) { return {a.v - b.v, a.d - b.d, a.dd - b.dd}; }
inline Jet operator*(Jet a, Jet b) {
  return {a.v * b.v, a.d * b.v + a.v * b.d, a.dd * b.v + 2 * a.d * b.d + a.v * b.dd};
}

/// f(a), from f, f′ and f″ at the value of a.
inline Jet chain(Jet a, Real f, Real f1, Real f2) {
  return {f, f1 * a.d, f1 * a.dd + f2 * a.d * a.d};
}

inline Jet operator/(Jet a, Jet b) {
  const Real r = 1 / b.v;
  return a * chain(b, r, -r * r, 2 * r * r * r);
}
inline Jet sqrt(Jet a) {
  const Real r = std::sqrt(a.v);
  return chain(a, r, 1 / (2 * r), -1 / (4 * r * a.v));
}
inline Jet sin(Jet a) { return chain(a, std::sin(a.v), std::cos(a.v), -std::sin(a.v)); }
inline Jet cos(Jet a) { return chain(a, std::cos(a.v), -std::sin(a.v), -std::cos(a.v)); }

/// The angle of (x, y), whose rate is (x ẏ − y ẋ) / (x² + y²).
inline Jet atan2(Jet y, Jet x) {
  const Real r2 = x.v * x.v + y.v * y.v, moment = x.v * y.d - y.v * x.d;
  const Real second = x.v * y.dd - y.v * x.dd - 2 * moment * (x.v * x.d + y.v * y.d) / r2;
  return {std::atan2(y.v, x.v), moment / r2, second / r2};
}

}  // namespace desmo::exact
