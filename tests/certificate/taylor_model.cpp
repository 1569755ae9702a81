// Each operation of Taylor models against exact arithmetic, and each term of a remainder at
// arguments that attain it: no function is left out, and none is bounded much too widely.

#include "formulations/verification/certificate/taylor_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <random>
#include <type_traits>
#include <utility>

namespace desmo::taylor_model_test {
namespace {

using Exact = boost::multiprecision::cpp_rational;
using Wide = boost::multiprecision::float128;
using Model = TaylorModel<double, 5>;
using Line = TaylorModel<double, 1>;

using Precise = TaylorModel<Compensated<double>, 5>;

Exact exactly(double x) { return Exact(x); }
Exact exactly(const Compensated<double>& x) { return Exact(x.value) + Exact(x.correction); }

template <class M>
Exact polynomial_at(const M& m, const Exact& s) {
  Exact sum = 0;
  for (std::size_t k = m.c.size(); k-- > 0;) sum = sum * s + exactly(m.c[k]);
  return sum;
}

double radius_of(double) { return 0; }
double radius_of(const Compensated<double>& x) { return x.enclosure().radius; }

/// Returns a bound on the distance of what a model holds from its polynomial.
template <class M>
double bound_of(const M& m) {
  double bound = m.rest;
  for (const auto& c : m.c) bound += radius_of(c);
  return bound;
}

/// Random models whose coefficients fall off, and functions that they hold.
class Models {
 public:
  Model next(double rest) {
    Model m;
    double size = std::pow(10, 6 * number() - 3);
    for (double& c : m.c) c = sign() * number() * size, size *= 0.3;
    m.rest = rest * number() * std::abs(m.c[0]);
    return m;
  }
  double argument() { return std::clamp(1.2 * sign() * number(), -1.0, 1.0); }
  /// Returns a function's value at s: anywhere within the remainder, often at its end.
  Exact within(const Model& m, double s) {
    return polynomial_at(m, s) + Exact(m.rest) * Exact(argument());
  }

 private:
  double number() { return uniform_(generator_); }
  double sign() { return number() < 0.5 ? -1 : 1; }

  std::mt19937 generator_{1};
  std::uniform_real_distribution<double> uniform_{0, 1};
};

/// Returns the largest distance from the polynomial that was seen, over the remainder.
template <class Operation>
double worst_of(double rest, Operation&& operation) {
  Models models;
  double worst = 0;
  for (int i = 0; i < (DESMO_SANITIZED ? 50 : 1000); ++i) {
    const Model a = models.next(rest), b = models.next(rest);
    const double s = models.argument();
    const Exact x = models.within(a, s), y = models.within(b, s);
    const Model result = operation(a, b);
    const Exact off = abs(operation(x, y) - polynomial_at(result, s));
    EXPECT_LE(off, Exact(result.rest)) << "at " << s;
    worst = std::max(worst, static_cast<double>(off / Exact(result.rest)));
  }
  return worst;
}

TEST(TaylorModel, HoldsSumsDifferencesAndProducts) {
  for (const double rest : {0.0, 1e-12, 0.1}) {
    EXPECT_GE(worst_of(rest, [](const auto& a, const auto& b) { return a + b; }), 0.25) << rest;
    EXPECT_GE(worst_of(rest, [](const auto& a, const auto& b) { return a - b; }), 0.25) << rest;
    worst_of(rest, [](const auto& a, const auto& b) { return a * b; });
  }
}

TEST(TaylorModel, HoldsSumsWithNumbersTimesModels) {
  for (const double rest : {0.0, 1e-12, 0.1})
    for (const auto& [mid, share] : {std::pair(-1e-3, 1.0), {0.7, 0.4}, {300.1, -1.0}}) {
      const Interval number(mid, rest * std::abs(mid));
      const Exact factor = Exact(mid) + Exact(number.radius) * Exact(share);
      const auto added = [&](const auto& a, const auto& x) {
        if constexpr (std::is_same_v<decltype(a), const Model&>) {
          Model sum = a;
          sum.add_product(number, x);
          return sum;
        } else {
          return Exact(a + factor * x);
        }
      };
      EXPECT_GE(worst_of(rest, added), 0.25) << rest << ", " << mid;
    }
}

/// At s = 1 all terms that a product cuts have one sign: 15 pairs of i + k > 5.
TEST(TaylorModel, BoundsWhatAProductCuts) {
  Model a, b;
  a.c = {0, 1, 1, 1, 1, 1};
  b.c = {0, 1, 2, 3, 4, 5};
  const Model product = a * b;
  const Exact off = polynomial_at(a, 1) * polynomial_at(b, 1) - polynomial_at(product, 1);
  EXPECT_EQ(off, 1 * 5 + 2 * 5 - 1 + 3 * 5 - 3 + 4 * 5 - 6 + 5 * 5 - 10);
  EXPECT_GE(product.rest, static_cast<double>(off));
  EXPECT_LE(product.rest, static_cast<double>(off) * (1 + 1e-12));
}

TEST(TaylorModel, BoundsProductsOfRemainders) {
  Model a(3), b(-5);
  a.rest = 2, b.rest = 7;
  EXPECT_GE((a * b).rest, 5 * 12 - 15);  // (3 + 2)(−5 − 7) + 15
  EXPECT_LE((a * b).rest, (5 * 12 - 15) * (1 + 1e-12));
}

/// Products of numbers that all lose nearly half a unit.
TEST(TaylorModel, BoundsTheRoundingOfProducts) {
  double worst = 0;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> digits(1, 2);
  for (int i = 0; i < (DESMO_SANITIZED ? 200 : 20'000); ++i) {
    Line a, b;
    a.c = {digits(generator), digits(generator)};
    b.c = {digits(generator), 0};  // nothing is cut
    const Line product = a * b;
    const Exact off = abs(polynomial_at(a, 1) * polynomial_at(b, 1) - polynomial_at(product, 1));
    ASSERT_LE(off, Exact(product.rest));
    worst = std::max(worst, static_cast<double>(off / Exact(product.rest)));
  }
  EXPECT_GE(worst, 0.25);
}

template <class M, class Function>
void expect_held(const M& a, const M& result, Function&& function, double attained) {
  const double bound = bound_of(result);
  double worst = 0;
  for (int i = 0; i <= 64; ++i)
    for (const double share : {-1.0, 1.0}) {
      const double s = i / 32.0 - 1;
      const Wide x = static_cast<Wide>(polynomial_at(a, s)) + Wide(a.rest) * Wide(share);
      const double off =
          static_cast<double>(abs(function(x) - static_cast<Wide>(polynomial_at(result, s))));
      EXPECT_LE(off, bound) << s;
      worst = std::max(worst, off / bound);
    }
  EXPECT_GE(worst, attained);
}

const auto sine = [](const Wide& x) { return Wide(sin(x)); };
const auto cosine = [](const Wide& x) { return Wide(cos(x)); };

/// Taylor's remainder: at the top of a sine d²/2 is nearly all that the first degree lacks; of the
/// fifth degree, d⁶/720.
TEST(TaylorModel, BoundsTheRemaindersOfSinesAndCosines) {
  const double top = 1.5707963267948966;
  Line line(top);
  line.c[1] = 0.1;
  expect_held(line, sin(line), sine, 1 / 1.5);
  line.c[0] = 0;
  expect_held(line, cos(line), cosine, 1 / 1.5);
  Model model(top);
  model.c[1] = 0.5;
  expect_held(model, sin(model), sine, 1 / 1.5);
  model.c[0] = 0;
  expect_held(model, cos(model), cosine, 1 / 1.5);
  Line uncertain(0);  // the remainder of the argument passes with the slope
  uncertain.c[1] = 1e-4, uncertain.rest = 1e-3;
  expect_held(uncertain, sin(uncertain), sine, 1 / 1.5);
}

TEST(TaylorModel, HoldsSinesOfManyAngles) {
  Models models;
  for (int i = 0; i < (DESMO_SANITIZED ? 10 : 200); ++i) {
    Model a = models.next(i % 2 ? 1e-3 : 0);
    expect_held(a, sin(a), sine, 0);
    expect_held(a, cos(a), cosine, 0);
  }
}

/// A line in compensated numbers takes another way: d⁶/720, and the remainder of the line itself.
TEST(TaylorModel, BoundsSinesOfCompensatedLines) {
  Precise line(1.5707963267948966);
  line.c[1] = 0.5;
  expect_held(line, sin(line), sine, 1 / 1.5);
  line.c = {0, 0.01};
  line.rest = 1e-3;
  expect_held(line, sin(line), sine, 1 / 1.5);
}

/// An angle at a time of 10¹² s has more digits than a double.
TEST(TaylorModel, KeepsTheDigitsOfCompensatedNumbers) {
  Precise time(1e12);
  time.c[1] = 0.005;
  const Precise z = sin(Precise(10.473) * time + Precise(0.3));
  const Wide exact = sin(Wide(10.473) * Wide(1e12) + Wide(0.3));
  const Interval found = z.c[0].enclosure();
  EXPECT_LE(static_cast<double>(abs(exact - Wide(found.mid))), found.radius + z.rest);
  EXPECT_LE(z.rest, 1e-10);       // d⁶/720 of d = 0.052
  EXPECT_LE(found.radius, 1e-8);  // the square of what the double nearest to the angle lacks, 1e-3
}

}  // namespace
}  // namespace desmo::taylor_model_test
