#pragma once

#include <algorithm>
#include <cmath>

namespace desmo {

/// An interval in midpoint–radius form: it holds every real number within `radius` of `mid`.
/// Each operation returns an interval that holds all results of numbers from its operands. The
/// radius includes the rounding of the midpoint and of itself (Rump, Fast and parallel interval
/// arithmetic, BIT 39, 1999). No operation switches the rounding mode, so all of them vectorise.
/// S: double, or LaneNumbers for four intervals.
///
/// Assumptions: IEEE arithmetic rounded to nearest; sine and cosine of the standard library have an
/// error of at most one unit in the last place, and lie within ±1.
///
///   const Interval x(3), y(1, 0.1);
///   const Interval z = x * sin(y);   // holds 3 sin t for every t from 0.9 to 1.1
template <class S>
struct BasicInterval {
  static constexpr double unit = 0x1p-53;  ///< largest relative error of one rounding
  /// Added to the radius of every result, so that it covers products that underflow. Intervals of
  /// numbers near 1e-150 or less are thus wide.
  static constexpr double tiny = 0x1p-500;

  S mid{0}, radius{0};

  BasicInterval() = default;
  BasicInterval(double exact) : mid(exact) {}
  BasicInterval(const S& m, const S& r) : mid(m), radius(r) {}

  /// Returns an upper bound of all magnitudes in the interval.
  S magnitude() const { return (size(mid) + radius) * above; }

  friend BasicInterval operator-(const BasicInterval& a) { return {-a.mid, a.radius}; }
  friend BasicInterval operator+(const BasicInterval& a, const BasicInterval& b) {
    return rounded(a.mid + b.mid, a.radius + b.radius, unit);
  }
  friend BasicInterval operator-(const BasicInterval& a, const BasicInterval& b) {
    return rounded(a.mid - b.mid, a.radius + b.radius, unit);
  }
  friend BasicInterval operator*(const BasicInterval& a, const BasicInterval& b) {
    return rounded(a.mid * b.mid, size(a.mid) * b.radius + a.radius * (size(b.mid) + b.radius),
                   unit);
  }
  friend BasicInterval sin(const BasicInterval& a) {
    using std::cos;
    using std::sin;
    return turned(a, sin(a.mid), cos(a.mid));
  }
  friend BasicInterval cos(const BasicInterval& a) {
    using std::cos;
    using std::sin;
    return turned(a, cos(a.mid), sin(a.mid));
  }

 private:
  static constexpr double above = 1 + 8 * unit;  // factor that covers seven roundings of a radius

  static S size(const S& x) {
    using std::abs;
    return abs(x);
  }
  static BasicInterval rounded(const S& mid, const S& radius, double relative) {
    return {mid, (radius + S(relative) * size(mid)) * S(above) + S(tiny)};
  }
  /// Returns f of an interval, where f is sine or cosine.
  /// - value, slope: f and its derivative f′ at the midpoint, as the library rounds them
  static BasicInterval turned(const BasicInterval& a, const S& value, const S& slope) {
    using std::min;
    // |f(mid + e) − f(mid)| ≤ |f′(mid)| radius + radius²/2 for |e| ≤ radius. The error of the slope
    // counts as two roundings; five more follow, seven in all.
    constexpr double last_place = 2 * unit;  // largest error of the library's value, relative
    constexpr double range = 2;              // no two values of f are further apart
    const BasicInterval result =
        rounded(value, a.radius * (size(slope) + a.radius * S(0.5)), last_place);
    return {value, min(S(range), result.radius)};
  }
};

using Interval = BasicInterval<double>;

}  // namespace desmo
