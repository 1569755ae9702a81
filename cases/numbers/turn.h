#pragma once

#include <array>
#include <cfloat>
#include <cmath>
#include <type_traits>

namespace desmo {

/// Sine and cosine of an angle, each as a rounded number and its remainder: sine + of_sine and
/// cosine + of_cosine. S: double, or LaneNumbers for four angles.
template <class S>
struct Turn {
  S sine, of_sine, cosine, of_cosine;
  S off;  ///< bound on the absolute error of either sum
};

/// Returns sine and cosine of k π/64 for k = 0 … 127, computed at the first call. The error of each
/// is at most 2^-95, and `off` is 0.
const std::array<Turn<double>, 128>& table_of_turns();

/// Returns sine and cosine of an angle [rad], computed in long double, which is slow. Assumes that
/// the library's error is at most one unit in the last place of long double.
inline Turn<double> library_turn(double angle) {
  const long double x = angle, s = std::sin(x), c = std::cos(x);
  const double sine = static_cast<double>(s), cosine = static_cast<double>(c);
  return {sine, static_cast<double>(s - sine), cosine, static_cast<double>(c - cosine),
          2 * LDBL_EPSILON};
}

/// Returns sine and cosine of an angle [rad], as double, remainder and a bound on the error. The
/// angle is k π/64 + r with an integer k. Sine and cosine of k π/64 are in the table. Those of r
/// are Taylor series; what the leading terms round off is kept. The bound holds where operations
/// stay as they are written (-ffp-contract=off). Where the angle of any lane is above 2^21 in
/// magnitude, or is NaN, library_turn() computes all lanes.
template <class S>
Turn<S> turn(const S& angle) {
  using std::fma;
  const auto lane = [](const S& x, int i) {
    if constexpr (std::is_same_v<S, double>)
      return x;
    else
      return x[i];
  };
  const auto for_each_lane = [](auto&& take) {
    if constexpr (std::is_same_v<S, double>)
      return take(0);
    else
      for (int i = 0; i < S::count; ++i) take(i);
  };
  const auto set = [](S& x, int i, double value) {
    if constexpr (std::is_same_v<S, double>)
      x = value;
    else
      x.set(i, value);
  };

  constexpr double max_angle = 0x1p21;
  bool is_large = false;
  for_each_lane([&](int i) { is_large = is_large || !(std::abs(lane(angle, i)) <= max_angle); });
  Turn<S> all{};
  const auto put = [&](int i, const Turn<double>& t) {
    set(all.sine, i, t.sine), set(all.of_sine, i, t.of_sine);
    set(all.cosine, i, t.cosine), set(all.of_cosine, i, t.of_cosine);
    set(all.off, i, t.off);
  };
  if (is_large) {
    for_each_lane([&](int i) { put(i, library_turn(lane(angle, i))); });
    return all;
  }

  // r + of_r = angle − k π/64 within 2^-86 (Cody & Waite). π/64 is high + middle + low; the first
  // two have 27 and 25 bits, so that their products with k are exact. So is the first difference.
  constexpr double per_step = 0x1.45f306dc9c883p4, whole = 0x1.8p52;
  constexpr double high = 0x3.243f6a8p-6, middle = 0x0.885a308p-34, low = 0x0.d313198a2e037p-62;
  const S k = (angle * S(per_step) + S(whole)) - S(whole);  // 64/π · angle, rounded to an integer
  const S first = angle - k * S(high), second = k * S(middle);
  const S difference = first - second, of_second = first - difference;
  const S lost = (first - (difference + of_second)) + (of_second - second);
  const S rest = lost - k * S(low);
  const S r = difference + rest, of_r = rest - (r - difference);

  // Here |r| < 0.0246. sin r = r + s with |s| < 2^-18.6; the error is at most 2^-69.8 by rounding
  // and 2^-70.4 by of_r r²/2, which is left out. cos r = 1 + c + of_c with c = −r²/2; the error is
  // at most 2^-75.
  const S square = r * r;
  const S of_square = fma(r, r, -square) + S(2) * r * of_r;
  const S s =
      of_r + r * square *
                 fma(square,
                     fma(square, fma(square, S(1 / 362880.0), S(-1 / 5040.0)), S(1 / 120.0)),
                     S(-1 / 6.0));
  const S c = S(-0.5) * square;
  const S of_c =
      fma(square * square, fma(square, fma(square, S(1 / 40320.0), S(-1 / 720.0)), S(1 / 24.0)),
          S(-0.5) * of_square);

  const std::array<Turn<double>, 128>& table = table_of_turns();
  for_each_lane([&](int i) { put(i, table[static_cast<long>(lane(k, i)) & 127]); });
  // Computes a (1 + c + of_c) + b (r + s), where of_a and of_b are the remainders of a and b.
  const auto combined = [&](const S& a, const S& of_a, const S& b, const S& of_b, S& value,
                            S& remainder) {
    const S of_sine = b * r, of_cosine = a * c;
    const S rounded = fma(b, r, -of_sine) + fma(a, c, -of_cosine);
    const S sum = a + of_sine, part = sum - a;
    const S total = sum + of_cosine, part2 = total - sum;
    const S cut =
        ((a - (sum - part)) + (of_sine - part)) + ((sum - (total - part2)) + (of_cosine - part2));
    const S small = fma(b, s, a * of_c) + fma(of_b, r, of_a * c);
    const S tail = (cut + rounded) + (of_a + small);
    value = total + tail;
    remainder = tail - (value - total);
  };
  Turn<S> result;
  combined(all.sine, all.of_sine, all.cosine, all.of_cosine, result.sine, result.of_sine);
  combined(all.cosine, all.of_cosine, -all.sine, -all.of_sine, result.cosine, result.of_cosine);
  // Covers the errors of sin r and cos r, and three roundings of sums with s, 2^-71.6 each.
  result.off = S(0x1p-68);
  return result;
}

}  // namespace desmo
