#pragma once

#include <algorithm>
#include <cmath>

namespace desmo {

/// An interval in midpoint–radius form: it holds every real number within `radius` of `mid`.
/// Each operation returns an interval that holds all results of numbers from its operands. The
/// radius takes up the rounding of the midpoint and its own (Rump, Fast and parallel interval
/// arithmetic, BIT 39, 1999). No operation switches the rounding mode, so all of them vectorise.
///
/// What is assumed: IEEE arithmetic rounded to nearest; sine and cosine of the standard library are
/// within one unit in the last place, and within ±1.
///
///   const Interval x(3), y(1, 0.1);
///   const Interval z = x * sin(y);   // holds 3 sin t for every t from 0.9 to 1.1
struct Interval {
  static constexpr double unit = 0x1p-53;  ///< largest relative error of one rounding
  /// Covers products that underflow; far below any length or rate.
  static constexpr double tiny = 0x1p-500;

  double mid = 0, radius = 0;

  Interval() = default;
  Interval(double exact) : mid(exact) {}
  Interval(double m, double r) : mid(m), radius(r) {}

  /// Returns an upper bound of all magnitudes in the interval.
  double magnitude() const { return (std::abs(mid) + radius) * above; }
  /// Returns an upper bound of the distance of any of its numbers from x.
  double distance(double x) const { return (std::abs(mid - x) + radius) * above; }

  friend Interval operator-(const Interval& a) { return {-a.mid, a.radius}; }
  friend Interval operator+(const Interval& a, const Interval& b) {
    return rounded(a.mid + b.mid, a.radius + b.radius, unit);
  }
  friend Interval operator-(const Interval& a, const Interval& b) {
    return rounded(a.mid - b.mid, a.radius + b.radius, unit);
  }
  friend Interval operator*(const Interval& a, const Interval& b) {
    return rounded(a.mid * b.mid,
                   std::abs(a.mid) * b.radius + a.radius * (std::abs(b.mid) + b.radius), unit);
  }
  friend Interval sin(const Interval& a) { return turned(a, std::sin(a.mid), std::cos(a.mid)); }
  friend Interval cos(const Interval& a) { return turned(a, std::cos(a.mid), std::sin(a.mid)); }
  /// Compares midpoints: the order of points, which splines look up.
  friend bool operator<(const Interval& a, const Interval& b) { return a.mid < b.mid; }

 private:
  static constexpr double above = 1 + 8 * unit;  // covers up to six roundings of a radius

  static Interval rounded(double mid, double radius, double relative) {
    return {mid, (radius + relative * std::abs(mid)) * above + tiny};
  }
  /// Returns a sine or cosine from its value and its slope at the midpoint.
  static Interval turned(const Interval& a, double value, double slope) {
    constexpr double last_place = 2 * unit, range = 2;
    const Interval result =
        rounded(value, a.radius * ((std::abs(slope) + last_place) + a.radius / 2), last_place);
    return {value, std::min(range, result.radius)};
  }
};

}  // namespace desmo
