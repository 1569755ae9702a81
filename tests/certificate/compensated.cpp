// Compensated arithmetic against exact arithmetic: the radius holds what is rounded off, and is of
// the second order in the unit roundoff.

#include "cases/numbers/compensated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <random>

#include "cases/mechanism/motion.h"
#include "formulations/base/per_level.h"

namespace desmo::compensated_test {
namespace {

using Exact = boost::multiprecision::cpp_rational;
using Wide = boost::multiprecision::float128;
using Number = Compensated<double>;

double number(std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  return uniform(generator) * std::pow(10, 8 * uniform(generator));
}

/// Returns the largest distance that was seen, over the radius, of a function of four numbers.
template <class Function>
double worst_of(Function&& f) {
  std::mt19937 generator(1);
  double worst = 0;
  for (int i = 0; i < 3000; ++i) {
    const double a = number(generator), b = number(generator), c = number(generator),
                 d = number(generator);
    const Number found = f(Number(a), Number(b), Number(c), Number(d));
    const Exact exact = f(Exact(a), Exact(b), Exact(c), Exact(d));
    const Exact off = abs(exact - Exact(found.value) - Exact(found.correction));
    EXPECT_LE(off, Exact(found.radius)) << a << ' ' << b << ' ' << c << ' ' << d;
    const Interval all = found.enclosure();
    EXPECT_LE(abs(exact - Exact(all.mid)), Exact(all.radius));
    if (found.radius > 0) worst = std::max(worst, static_cast<double>(off / Exact(found.radius)));
  }
  return worst;
}

TEST(Compensated, HoldsSumsAndProducts) {
  const auto sum = [](auto a, auto b, auto c, auto d) { return decltype(a)(a + b - c + d); };
  const auto product = [](auto a, auto b, auto c, auto d) { return decltype(a)(a * b * (c * d)); };
  const auto both = [](auto a, auto b, auto c, auto d) {
    return decltype(a)((a + b) * (c - d) - a * c * (b + d));
  };
  EXPECT_GT(worst_of(sum), 0.2);
  EXPECT_GT(worst_of(product), 0.2);
  EXPECT_GT(worst_of(both), 0.2);
}

TEST(Compensated, AddsProductsAsSumAndProductDo) {
  const auto added = [](auto a, auto b, auto c, auto d) {
    auto sum = a;
    if constexpr (std::is_same_v<decltype(a), Number>) {
      sum.add_product(b * c, d.value);
      sum.add_product(a + b, c.value);
    } else {
      sum = a + b * c * d + (a + b) * c;
    }
    return sum;
  };
  EXPECT_GT(worst_of(added), 0.2);
}

/// Operands whose corrections are rounded most: whole products and sums of them, which cancel each
/// other or stand alone.
TEST(Compensated, HoldsWhereCorrectionsAreRounded) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(1, 2);
  const auto expect_held = [](const Number& found, const Exact& exact) {
    const Exact off = abs(exact - Exact(found.value) - Exact(found.correction));
    EXPECT_LE(off, Exact(found.radius) * (1 + Exact(0x1p-40)));
  };
  const auto exact = [](const Number& a) { return Exact(a.value) + Exact(a.correction); };
  for (int i = 0; i < (DESMO_SANITIZED ? 2 : 50); ++i) {
    const double c = 0x1p-30 * uniform(generator), d = 0x1p-30 * uniform(generator);
    const double x = uniform(generator), y = uniform(generator);
    const double lost = (x - (x + y)) + y, small = 0x1p-55 * uniform(generator);
    const Number with_lost(x, -lost - small, 0), rest(y, small, 0);
    expect_held(with_lost + rest, exact(with_lost) + exact(rest));
    for (const double e : {0.0, d, -c, -c * x, -c * y / x, 0x1p-30}) {
      for (const double f : {0.0, c, 0x1p-60 * x}) {
        for (const double v : {1.0, x}) {
          const Number a(v, f, 0), b(y, e, 0), one(1, e, 0), zero(0, e, 0);
          for (const Number& other : {b, one, zero}) {
            expect_held(a * other, exact(a) * exact(other));
            expect_held(a + other, exact(a) + exact(other));
            for (const double factor : {1.0, x, y}) {
              Number sum = a;
              sum.add_product(other, factor);
              expect_held(sum, exact(a) + exact(other) * Exact(factor));
            }
          }
        }
      }
    }
  }
}

TEST(Compensated, HoldsProductsThatUnderflow) {
  for (const double b : {1.1e-120, 1.1e-200}) {  // what is lost of the product, or all of it
    const Interval product = (Number(1e-200) * Number(b) * Number(1e100)).enclosure();
    EXPECT_LE(abs(Exact(1e-200) * Exact(b) * Exact(1e100) - Exact(product.mid)),
              Exact(product.radius));
  }
}

TEST(Compensated, HoldsProductsOfUncertainNumbers) {
  const Number zero(0, 0, 0x1p-20);
  EXPECT_LE(0x1p-40, (zero * zero).radius);
  const Number factor(1, 0, 0x1p-40);
  Number sum(2);
  sum.add_product(factor, 3);
  for (const Exact& end : {1 - Exact(0x1p-40), 1 + Exact(0x1p-40)}) {
    EXPECT_LE(abs(2 + 3 * end - Exact(sum.value) - Exact(sum.correction)), Exact(sum.radius));
    for (const Number& product : {factor * Number(3), Number(3) * factor})
      EXPECT_LE(abs(3 * end - Exact(product.value) - Exact(product.correction)),
                Exact(product.radius));
  }
}

TEST(Compensated, HoldsQuotientsAndRootsOfUncertainNumbers) {
  // Numbers of a file far from the origin have fewer than ten certain digits (file_variation.h).
  for (const double off : {1e-14, 1e-12, 1e-3, 0.4}) {
    const Number quotient = Number(1) / Number(1, 0, off);
    const double of_quotient = off / (1 - off), of_root = off / (1 + std::sqrt(1 - off));
    EXPECT_LE(of_quotient, quotient.radius * (1 + 1e-12));
    EXPECT_GE(1.5 * of_quotient + 1e-15, quotient.radius);
    const Number root = sqrt(Number(1, 0, off));
    EXPECT_LE(of_root, root.radius * (1 + 1e-12));
    EXPECT_GE(1.5 * of_root + 1e-15, root.radius);
  }
  EXPECT_EQ((Number(1) / Number(1, 0, 0.6)).radius, INFINITY);
  EXPECT_EQ((Number(1) / Number(1, 0, 2)).radius, INFINITY);
}

/// Radii of many numbers: each is lost beside the first.
TEST(Compensated, CountsRoundingOfItsRadius) {
  constexpr int terms = 1000;
  constexpr double lost = 0x1.fp-54;
  Number sum(0, 0, 1);
  for (int i = 0; i < terms; ++i) sum = sum + Number(0, 0, lost);
  const double radius = sum.enclosure().radius;
  EXPECT_LE(1 + terms * Exact(lost), Exact(radius));
  EXPECT_LE(radius, 1 + 10 * terms * lost);
}

TEST(Compensated, HoldsWhatMotionsAreInExactArithmetic) {
  const std::vector<Motion> motions{
      Polynomial{{0.3, -1.7, 0.25, 1e-3}},
      HarmonicSum{0.1, {{0.7, 6.28318530717958, 0.2}, {-1e-3, 100, -3}}},
      make_spline({0, 0.3, 1.1, 2}, {0.1, -0.7, 0.4, 0.2}, SplineEnds::natural)};
  PerLevel<double> worst;
  for (const Motion& motion : motions)
    for (int i = 0; i < 1000; i += DESMO_SANITIZED ? 20 : 1) {
      const double t = i * 0.0021;
      const MotionSample<Number> z = sample(motion, Number(t));
      const MotionSample<Wide> exact = sample(motion, Wide(t));
      const auto compare = [&](const Number& found, const Wide& expected, double& w) {
        const Wide off = abs(expected - Wide(found.value) - Wide(found.correction));
        EXPECT_LE(off, Wide(found.radius) + 1e-31) << "at " << t;
        w = std::max(w, static_cast<double>(off / found.radius));
      };
      compare(z.position, exact.position, worst.position);
      compare(z.velocity, exact.velocity, worst.velocity);
      compare(z.acceleration, exact.acceleration, worst.acceleration);
    }
  for (const Level level : all_levels) EXPECT_GT(worst[level], 0.05);
}

}  // namespace
}  // namespace desmo::compensated_test
