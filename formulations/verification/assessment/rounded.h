#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace desmo {

/// A double and a bound on its distance from the exact number. Arithmetic propagates the bounds and
/// adds its own rounding (running error analysis; Higham, Accuracy and Stability of Numerical
/// Algorithms, 3.3). An expression in such numbers yields its rounding and all effects, of every
/// order, that the errors of its operands can have. The rounding of the bounds themselves is
/// neglected.
struct Rounded {
  double value = 0, radius = 0;

  Rounded() = default;
  Rounded(double exact) : value(exact) {}
  Rounded(double v, double r) : value(v), radius(r) {}

  /// Returns the largest magnitude that the exact number can have.
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
  /// Returns a sine or cosine. Libraries round them by two units at most.
  static Rounded turned(const Rounded& a, double v, double slope) {
    constexpr double largest = 2;  // range of a sine: the error when the angle is unknown
    return {v,
            std::min(largest, a.radius * (std::abs(slope) + a.radius / 2) + 2 * u * std::abs(v))};
  }
};

}  // namespace desmo
