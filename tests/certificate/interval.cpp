// Each operation of intervals against exact arithmetic: no result is left out, and no radius is
// more than a few times what was seen.

#include "cases/numbers/interval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <random>

namespace desmo::interval_test {
namespace {

using Exact = boost::multiprecision::cpp_rational;
using Wide = boost::multiprecision::float128;

/// Random intervals: points and wide ones, of magnitudes from 1e-8 to 1e8.
class Intervals {
 public:
  explicit Intervals(double radius) : radius_(radius) {}

  Interval next() {
    const double mid = sign() * number();
    return {mid, radius_ * std::abs(mid) * uniform_(generator_)};
  }
  /// Returns a number of the interval, often one of its ends.
  Exact within(const Interval& x) {
    const double share = std::clamp(1.5 * sign() * uniform_(generator_), -1.0, 1.0);
    return Exact(x.mid) + Exact(x.radius) * Exact(share);
  }

 private:
  double number() { return std::pow(10, 16 * uniform_(generator_) - 8); }
  double sign() { return uniform_(generator_) < 0.5 ? -1 : 1; }

  double radius_;
  std::mt19937 generator_{1};
  std::uniform_real_distribution<double> uniform_{0, 1};
};

/// Returns the largest distance from the midpoint that was seen, over the radius.
template <class Operation>
double worst_of(double radius, Operation&& operation) {
  Intervals intervals(radius);
  double worst = 0;
  for (int i = 0; i < (DESMO_SANITIZED ? 2000 : 20'000); ++i) {
    const Interval a = intervals.next(), b = intervals.next();
    const Exact x = intervals.within(a), y = intervals.within(b);
    const Interval result = operation(a, b);
    const Exact off = abs(operation(x, y) - Exact(result.mid));
    EXPECT_LE(off, Exact(result.radius)) << a.mid << ' ' << b.mid;
    worst = std::max(worst, static_cast<double>(off / Exact(result.radius)));
  }
  return worst;
}

TEST(Interval, HoldsSumsDifferencesAndProducts) {
  for (const double radius : {0.0, 1e-16, 1e-9, 0.5}) {
    EXPECT_GT(worst_of(radius, [](auto a, auto b) { return decltype(a)(a + b); }), 0.9);
    EXPECT_GT(worst_of(radius, [](auto a, auto b) { return decltype(a)(a - b); }), 0.9);
    EXPECT_GT(worst_of(radius, [](auto a, auto b) { return decltype(a)(a * b); }), 0.9);
  }
}

TEST(Interval, HoldsProductsThatUnderflow) {
  const Interval product = Interval(1e-200) * Interval(1.1e-200);
  EXPECT_LE(abs(Exact(1e-200) * Exact(1.1e-200) - Exact(product.mid)), Exact(product.radius));
  const Interval wide = Interval(1, 1e-300) * Interval(0, 1e-300);
  EXPECT_LE(Exact(1e-300) * (1 + Exact(1e-300)), Exact(wide.radius));
}

TEST(Interval, IsExactWhereNothingIsRounded) {
  EXPECT_EQ((-Interval(3, 0.5)).mid, -3);
  EXPECT_EQ((-Interval(3, 0.5)).radius, 0.5);
  EXPECT_LT((Interval(0.1) - Interval(0.1)).radius, 1e-100);
  EXPECT_LT((Interval(0.1) * Interval(0)).radius, 1e-100);
}

TEST(Interval, MagnitudeIsAnUpperBound) {
  Intervals intervals(0.5);
  for (int i = 0; i < (DESMO_SANITIZED ? 200 : 10'000); ++i) {
    const Interval a = intervals.next();
    EXPECT_LE(abs(Exact(a.mid)) + Exact(a.radius), Exact(a.magnitude()));
  }
}

/// Largest distance of f of the numbers in an interval from the midpoint of its result, over the
/// radius, where angles have magnitudes up to `largest`.
template <class Function>
double worst_of_function(double radius, double largest, Function&& f) {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double worst = 0;
  for (int i = 0; i < (DESMO_SANITIZED ? 500 : 50'000); ++i) {
    const Interval a(largest * uniform(generator), radius * std::abs(uniform(generator)));
    const double share = std::clamp(1.5 * uniform(generator), -1.0, 1.0);
    const Interval result = f(a);
    const Wide off = abs(f(Wide(a.mid) + Wide(a.radius) * share) - Wide(result.mid));
    const Wide of_reference = largest * 1e-33;  // its own rounding of such an angle
    EXPECT_LE(off, Wide(result.radius) + of_reference) << a.mid << " within " << a.radius;
    worst = std::max(worst, static_cast<double>(off / result.radius));
  }
  return worst;
}

TEST(Interval, HoldsSinesAndCosines) {
  for (const double largest : {1e-3, 4.0, 1e6, 1e15})
    for (const double radius : {0.0, 1e-16, 1e-9, 0.5, 4.0}) {
      const auto sine = [](auto x) { return decltype(x)(sin(x)); };
      const auto cosine = [](auto x) { return decltype(x)(cos(x)); };
      // The worst is that of the library where the interval is a point, a quarter or half
      // of what is assumed.
      EXPECT_GT(worst_of_function(radius, largest, sine), 0.24) << radius << " at " << largest;
      EXPECT_GT(worst_of_function(radius, largest, cosine), 0.24) << radius << " at " << largest;
    }
}

}  // namespace
}  // namespace desmo::interval_test
