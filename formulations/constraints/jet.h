#pragma once

#include <cmath>

namespace desmo {

/// A function of time at one instant: its value and its first two time derivatives. An expression
/// for positions, evaluated in jets, also yields its velocity and acceleration without hand-written
/// derivatives. Only the operations of constraint residuals are provided.
template <class S>
struct Jet {
  S value{0}, first{0}, second{0};

  Jet() = default;
  Jet(const S& constant) : value(constant) {}
  Jet(const S& v, const S& d, const S& dd) : value(v), first(d), second(dd) {}

  friend Jet operator-(const Jet& a) { return {-a.value, -a.first, -a.second}; }
  friend Jet operator+(const Jet& a, const Jet& b) {
    return {a.value + b.value, a.first + b.first, a.second + b.second};
  }
  friend Jet operator-(const Jet& a, const Jet& b) {
    return {a.value - b.value, a.first - b.first, a.second - b.second};
  }
  friend Jet operator*(const Jet& a, const Jet& b) {
    return {a.value * b.value, a.first * b.value + a.value * b.first,
            a.second * b.value + S(2) * (a.first * b.first) + a.value * b.second};
  }
  friend Jet sin(const Jet& a) {
    using std::cos;
    using std::sin;
    const S sine = sin(a.value), cosine = cos(a.value);
    return chain(a, sine, cosine, -sine);
  }
  friend Jet cos(const Jet& a) {
    using std::cos;
    using std::sin;
    const S sine = sin(a.value), cosine = cos(a.value);
    return chain(a, cosine, -sine, -cosine);
  }

 private:
  /// Returns f(a) from f, f′ and f″ at the value of a.
  static Jet chain(const Jet& a, const S& f, const S& f1, const S& f2) {
    return {f, f1 * a.first, f1 * a.second + f2 * (a.first * a.first)};
  }
};

}  // namespace desmo
