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

std::mt19937 generator(1);

double random(double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(generator);
}

/// Returns an interval of a magnitude from 1e-8 to 1e8, with up to this relative radius.
Interval any_interval(double radius) {
  const double mid = (random(0, 1) < 0.5 ? -1 : 1) * std::pow(10, random(-8, 8));
  return {mid, radius * std::abs(mid) * random(0, 1)};
}

/// Returns the largest distance from the midpoint that was seen, over the radius, of an operation
/// in numbers N of two intervals, often at one of their ends.
/// - draw(): an interval
/// - of_reference: error of the operation in N
template <class N, class Draw, class Operation>
double worst_of(int count, Draw&& draw, Operation&& operation, double of_reference = 0) {
  const auto within = [](const Interval& x) {
    const double share = std::clamp(random(-1.5, 1.5), -1.0, 1.0);
    return N(N(x.mid) + N(x.radius) * N(share));
  };
  double worst = 0;
  for (int i = 0; i < count / (DESMO_SANITIZED ? 20 : 1); ++i) {
    const Interval a = draw(), b = draw();
    const Interval result = operation(a, b);
    const N off = abs(operation(within(a), within(b)) - N(result.mid));
    EXPECT_LE(off, N(result.radius) + N(of_reference)) << a.mid << ' ' << b.mid;
    worst = std::max(worst, static_cast<double>(off / N(result.radius)));
  }
  return worst;
}

TEST(Interval, HoldsSumsDifferencesAndProducts) {
  for (const double radius : {0.0, 1e-16, 1e-9, 0.5}) {
    const auto worst = [&](auto&& operation) {
      return worst_of<Exact>(
          20'000, [&] { return any_interval(radius); }, operation);
    };
    EXPECT_GT(worst([](auto a, auto b) { return decltype(a)(a + b); }), 0.9);
    EXPECT_GT(worst([](auto a, auto b) { return decltype(a)(a - b); }), 0.9);
    EXPECT_GT(worst([](auto a, auto b) { return decltype(a)(a * b); }), 0.9);
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
  for (int i = 0; i < (DESMO_SANITIZED ? 200 : 10'000); ++i) {
    const Interval a = any_interval(0.5);
    EXPECT_LE(abs(Exact(a.mid)) + Exact(a.radius), Exact(a.magnitude()));
  }
}

TEST(Interval, HoldsSinesAndCosines) {
  for (const double largest : {1e-3, 4.0, 1e6, 1e15})
    for (const double radius : {0.0, 1e-16, 1e-9, 0.5, 4.0}) {
      const auto worst = [&](auto&& function) {
        const auto draw = [&] {
          return Interval(random(-largest, largest), radius * random(0, 1));
        };
        return worst_of<Wide>(50'000, draw, function, largest * 1e-33);
      };
      // The worst is that of the library where the interval is a point, a quarter or half of what
      // is assumed.
      const auto sine = [](auto x, auto) { return decltype(x)(sin(x)); };
      const auto cosine = [](auto x, auto) { return decltype(x)(cos(x)); };
      EXPECT_GT(worst(sine), 0.24) << radius << " at " << largest;
      EXPECT_GT(worst(cosine), 0.24) << radius << " at " << largest;
    }
}

}  // namespace
}  // namespace desmo::interval_test
