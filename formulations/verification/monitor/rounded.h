#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace desmo {

/// A number in double precision and a bound of how far the exact one is from it. Arithmetic carries
/// the bound along and adds its own rounding (running error analysis; Higham, Accuracy and
/// Stability of Numerical Algorithms, 3.3): an expression evaluated in such numbers yields all that
/// the errors of its operands can do to it, to every order, and what its evaluation did itself.
/// The rounding of the bounds is not counted.
struct Rounded {
  double value = 0, radius = 0;

  Rounded() = default;
  Rounded(double exact) : value(exact) {}
  Rounded(double v, double r) : value(v), radius(r) {}

  /// The largest magnitude that the exact number can have.
  double most() const { return std::abs(value) + radius; }

  friend Rounded operator-(const Rounded& a) { return {-a.value, a.radius}; }
  friend Rounded operator+(const Rounded& a, const Rounded& b) {
    return of(a.value + b.value, a.radius + b.radius);
  }
  friend Rounded operator-(const Rounded& a, const Rounded& b) {
    return of(a.value - b.value, a.radius + b.radius);
  }
  friend Rounded operator*(const Rounded& a, const Rounded& b) {
    return of(a.value * b.value,
              std::abs(a.value) * b.radius + a.radius * (std::abs(b.value) + b.radius));
  }
  friend Rounded sin(const Rounded& a) { return turned(a, std::sin(a.value), std::cos(a.value)); }
  friend Rounded cos(const Rounded& a) { return turned(a, std::cos(a.value), std::sin(a.value)); }
  friend bool operator<(const Rounded& a, const Rounded& b) { return a.value < b.value; }

 private:
  static constexpr double u = std::numeric_limits<double>::epsilon() / 2;

  static Rounded of(double v, double r) { return {v, r + u * std::abs(v)}; }
  /// A sine or cosine, which a library rounds to two units at most, and its slope.
  static Rounded turned(const Rounded& a, double v, double slope) {
    constexpr double largest = 2;  // from -1 to 1: of an angle that nobody knows
    return {v,
            std::min(largest, a.radius * (std::abs(slope) + a.radius / 2) + 2 * u * std::abs(v))};
  }
};

}  // namespace desmo
