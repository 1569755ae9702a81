#pragma once

#include <cmath>

#include "cases/mechanism/level.h"

namespace desmo::exact {

using Real = long double;

inline constexpr Real pi = 3.14159265358979323846264338327950288L;

/// A function of time at one instant: value v and time derivatives d, dd. A formula written for
/// positions then yields velocities and accelerations too. R: a real type with its own functions.
template <class R>
struct BasicJet {
  R v = 0, d = 0, dd = 0;

  constexpr BasicJet() = default;
  constexpr BasicJet(R value) : v(value) {}  // a constant
  constexpr BasicJet(R value, R rate, R second) : v(value), d(rate), dd(second) {}

  static BasicJet time(R t) { return {t, 1, 0}; }
  /// Returns the value, or its first or second derivative.
  constexpr R at(Level level) const {
    return level == Level::position ? v : level == Level::velocity ? d : dd;
  }

  friend BasicJet operator-(BasicJet a) { return {-a.v, -a.d, -a.dd}; }
  friend BasicJet operator+(BasicJet a, BasicJet b) { return {a.v + b.v, a.d + b.d, a.dd + b.dd}; }
  friend BasicJet operator-(BasicJet a, BasicJet b) { return {a.v - b.v, a.d - b.d, a.dd - b.dd}; }
  friend BasicJet operator*(BasicJet a, BasicJet b) {
    return {a.v * b.v, a.d * b.v + a.v * b.d, a.dd * b.v + 2 * a.d * b.d + a.v * b.dd};
  }
  friend BasicJet operator/(BasicJet a, BasicJet b) {
    const R r = 1 / b.v;
    return a * chain(b, r, -r * r, 2 * r * r * r);
  }
  friend BasicJet sqrt(BasicJet a) {
    using std::sqrt;
    const R r = sqrt(a.v);
    return chain(a, r, 1 / (2 * r), -1 / (4 * r * a.v));
  }
  friend BasicJet sin(BasicJet a) {
    using std::cos;
    using std::sin;
    return chain(a, sin(a.v), cos(a.v), -sin(a.v));
  }
  friend BasicJet cos(BasicJet a) {
    using std::cos;
    using std::sin;
    return chain(a, cos(a.v), -sin(a.v), -cos(a.v));
  }
  /// Returns the angle of (x, y), whose rate is (x ẏ − y ẋ) / (x² + y²).
  friend BasicJet atan2(BasicJet y, BasicJet x) {
    using std::atan2;
    const R r2 = x.v * x.v + y.v * y.v, moment = x.v * y.d - y.v * x.d;
    const R second = x.v * y.dd - y.v * x.dd - 2 * moment * (x.v * x.d + y.v * y.d) / r2;
    return {atan2(y.v, x.v), moment / r2, second / r2};
  }

 private:
  /// Returns f(a) by the chain rule, from f, f′ and f″ at a.v.
  static BasicJet chain(BasicJet a, R f, R f1, R f2) {
    return {f, f1 * a.d, f1 * a.dd + f2 * a.d * a.d};
  }
};

using Jet = BasicJet<Real>;

}  // namespace desmo::exact
