#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "cases/numbers/compensated.h"
#include "cases/numbers/derived.h"
#include "cases/numbers/interval.h"
#include "formulations/verification/certificate/lane_numbers.h"

namespace desmo {

/// Rule by which a Taylor model with coefficients S bounds rounding. Operations of double and of
/// LaneNumbers round: the remainder takes that up. Compensated<double> bounds its own error.
template <class S>
struct Coefficient {
  using Bound = S;
  static constexpr double unit = Interval::unit;
  static S magnitude(const S& x) {
    using std::abs;
    return abs(x);
  }
  /// Returns a b + sum.
  static S sum(const S& a, const S& b, const S& sum) {
    using std::fma;
    return fma(a, b, sum);
  }
  /// Returns whether x is 0, so that products with x are skipped. To ask costs more than a product
  /// of doubles: false for these.
  static constexpr bool is_none(const S&) { return false; }
  /// Returns a bound on the error of a computed sine or cosine f: one unit in the last place.
  static S uncertainty_of_turn(const S& f) { return magnitude(f) * S(2 * unit); }
};
template <>
struct Coefficient<Compensated<double>> {
  using Bound = double;
  static constexpr double unit = 0;
  static double magnitude(const Compensated<double>& x) { return x.magnitude(); }
  static Compensated<double> sum(const Compensated<double>& a, const Compensated<double>& b,
                                 const Compensated<double>& sum) {
    return sum + a * b;
  }
  static bool is_none(const Compensated<double>& x) {
    return x.value == 0 && x.correction == 0 && x.radius == 0;
  }
  static double uncertainty_of_turn(const Compensated<double>&) { return 0; }
};

/// A function of s in [−1, 1], enclosed by a polynomial of degree D and a remainder: it is within
/// `rest` of Σ c[k] sᵏ, for each s (Makino & Berz, Reliable Computing 5, 1999). Each operation
/// returns a model that holds the result for all functions that its operands hold. No rounding mode
/// is switched.
///
///   TaylorModel<double, 5> t(0.5);   // t = 0.5 + 0.01 s: time within a step
///   t.c[1] = 0.01;
///   const auto z = sin(t) * t;       // holds sin(t(s)) t(s) for every s
template <class S, int D>
struct TaylorModel {
  static_assert(D >= 1);
  using Traits = Coefficient<S>;
  using Bound = typename Traits::Bound;

  std::array<S, D + 1> c{};
  Bound rest{0};

  TaylorModel() = default;
  TaylorModel(double exact) { c[0] = S(exact); }
  /// Takes a number as the file means it. The remainder covers what a double c[0] lacks of it.
  explicit TaylorModel(const Derived& x) {
    if constexpr (std::is_constructible_v<S, const Derived&>) {
      c[0] = S(x);
    } else {
      c[0] = S(x.value);
      rest = Bound((std::abs(x.correction) + x.radius) * above);
    }
  }

  /// Returns a bound on the polynomial's magnitude; callers count the rounding of this sum.
  Bound polynomial() const { return Traits::magnitude(c[0]) + slopes(); }
  /// Returns a bound on the sum of all terms without the constant one; callers count its rounding.
  Bound slopes() const {
    Bound sum = Traits::magnitude(c[1]);
    for (int k = 2; k <= D; ++k) sum = sum + Traits::magnitude(c[k]);
    return sum;
  }
  /// Returns a bound on the function's magnitude.
  Bound magnitude() const { return (polynomial() + rest) * Bound(above); }
  /// Returns a bound on the function's distance from the constant term.
  Bound variation() const { return (slopes() + rest) * Bound(above); }

  friend TaylorModel operator-(const TaylorModel& a) {
    TaylorModel r;
    for (int k = 0; k <= D; ++k) r.c[k] = -a.c[k];
    r.rest = a.rest;
    return r;
  }
  friend TaylorModel operator+(const TaylorModel& a, const TaylorModel& b) {
    TaylorModel r;
    for (int k = 0; k <= D; ++k) r.c[k] = a.c[k] + b.c[k];
    r.rest = with_rounding(a.rest + b.rest, [&] { return r.polynomial(); });
    return r;
  }
  friend TaylorModel operator-(const TaylorModel& a, const TaylorModel& b) {
    TaylorModel r;
    for (int k = 0; k <= D; ++k) r.c[k] = a.c[k] - b.c[k];
    r.rest = with_rounding(a.rest + b.rest, [&] { return r.polynomial(); });
    return r;
  }
  friend TaylorModel operator*(const TaylorModel& a, const TaylorModel& b) {
    TaylorModel r;
    for (int i = 0; i <= D; ++i) {
      if (Traits::is_none(a.c[i])) continue;
      for (int k = 0; i + k <= D; ++k)
        if (!Traits::is_none(b.c[k])) r.c[i + k] = Traits::sum(a.c[i], b.c[k], r.c[i + k]);
    }
    // Terms above degree D are cut: aᵢ bₖ with i + k > D.
    Bound cut(0), of_b(0);
    for (int i = 1; i <= D; ++i) {
      of_b = of_b + Traits::magnitude(b.c[D + 1 - i]);
      cut = cut + Traits::magnitude(a.c[i]) * of_b;
    }
    const Bound of_a = a.polynomial(), all_of_b = b.polynomial();
    // A coefficient is the sum of at most D + 1 products, each rounded at most D + 1 times.
    r.rest = with_rounding(cut + of_a * b.rest + a.rest * (all_of_b + b.rest),
                           [&] { return Bound(D + 1) * (of_a * all_of_b); });
    return r;
  }
  /// Adds number × x.
  void add_product(const BasicInterval<S>& number, const TaylorModel& x) {
    for (int k = 0; k <= D; ++k) c[k] = Traits::sum(number.mid, x.c[k], c[k]);
    rest = with_rounding(
        rest + Traits::magnitude(number.mid) * x.rest + number.radius * (x.polynomial() + x.rest),
        [&] { return polynomial(); });
  }
  friend TaylorModel sin(const TaylorModel& a) {
    using std::cos;
    using std::sin;
    const S sine = sin(a.c[0]), cosine = cos(a.c[0]);
    return turned(a, {sine, cosine, -sine, -cosine});
  }
  friend TaylorModel cos(const TaylorModel& a) {
    using std::cos;
    using std::sin;
    const S sine = sin(a.c[0]), cosine = cos(a.c[0]);
    return turned(a, {cosine, -sine, -cosine, sine});
  }
  /// Compares the constant terms: a spline looks up its pieces by it. Callers make sure that no
  /// knot lies within the range of the function.
  friend bool operator<(const TaylorModel& a, const TaylorModel& b) { return a.c[0] < b.c[0]; }

 private:
  // Covers the rounding of at most 60 positive terms.
  static constexpr double above = 1 + 64 * Interval::unit;

  /// Returns a remainder, enlarged by rounding errors. rounded(): the sum of the magnitudes of all
  /// rounded numbers.
  template <class Rounded>
  static Bound with_rounding(const Bound& rest, const Rounded& rounded) {
    if constexpr (Traits::unit > 0)
      return (rest + Bound(Traits::unit) * rounded()) * Bound(above) + Bound(Interval::tiny);
    else
      return rest * Bound(above) + Bound(Interval::tiny);
  }
  /// Returns f(a) for f = sin or cos, from f … f‴ at c₀. By Taylor's formula, f(c₀ + d) =
  /// Σ f⁽ᵏ⁾(c₀) dᵏ/k! + f⁽ᴰ⁺¹⁾(ξ) dᴰ⁺¹/(D + 1)!, where the last derivative is at most 1.
  static TaylorModel turned(const TaylorModel& a, const std::array<S, 4>& derivatives) {
    if (D > 1 && std::all_of(a.c.begin() + 2, a.c.end(), Traits::is_none))
      return turned_line(a, derivatives);
    TaylorModel d = a;
    d.c[0] = S(0);
    const Bound far = a.variation();
    Bound last(1);  // |d|ᵏ/k!; after the loop k = D + 1
    for (int k = 1; k <= D + 1; ++k) last = last * far * Bound((1 + 0x1p-51) / k);
    TaylorModel sum = term(D, derivatives[D % 4]);
    for (int k = D; k-- > 0;) sum = sum * d + term(k, derivatives[k % 4]);
    sum.rest = with_rounding(sum.rest + last, [] { return Bound(0); });
    return sum;
  }
  /// Returns the same for a line c₀ + c₁ s, without Horner's rule. The remainder of a changes f by
  /// no more than itself.
  static TaylorModel turned_line(const TaylorModel& a, const std::array<S, 4>& derivatives) {
    constexpr double up = 1 + 0x1p-51;
    const Bound far = Traits::magnitude(a.c[1]);
    TaylorModel r;
    S power(1);                  // c₁ᵏ
    Bound of_power(1), last(1);  // |c₁|ᵏ, and |c₁|ᵏ/k!; after the loop k = D + 1
    Bound rest = a.rest;
    for (int k = 0; k <= D; ++k) {
      const TaylorModel f = term(k, derivatives[k % 4]);
      r.c[k] = f.c[0] * power;
      rest = rest + f.rest * of_power;
      power = power * a.c[1];
      of_power = of_power * far * Bound(up);
      last = last * far * Bound(up / (k + 1));
    }
    // A coefficient takes k + 1 roundings at most.
    r.rest = with_rounding(rest + last, [&] { return Bound(D + 1) * r.polynomial(); });
    return r;
  }
  /// Returns the constant f/k! for a sine or cosine f.
  static TaylorModel term(int k, const S& f) {
    double factorial = 1;
    for (int i = 2; i <= k; ++i) factorial *= i;
    const Bound of_f = Traits::uncertainty_of_turn(f),
                of_factor = k > 2 ? Interval::unit / factorial : 0;  // the first three are exact
    TaylorModel r;
    r.c[0] = S(1 / factorial) * f;
    r.rest = with_rounding(of_f * Bound(1 / factorial) + of_factor * (Traits::magnitude(f) + of_f),
                           [&] { return Traits::magnitude(r.c[0]); });
    return r;
  }
};

}  // namespace desmo
