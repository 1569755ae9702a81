// Sine, cosine, arctangent and unwrapped angles of generated code.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "formulations/equations/turned_angle.h"

namespace desmo::elementary_test {
namespace {

TEST(Elementary, FunctionsAgreeWithTheStandardLibrary) {
  std::mt19937 generator(5);
  for (const double range : {1e-6, 1.0, 10.0, 1e3, 9e5}) {
    std::uniform_real_distribution<double> uniform(-range, range);
    for (int i = 0; i < 20000; ++i) {
      const double x = uniform(generator), y = uniform(generator);
      const double unit = std::numeric_limits<double>::epsilon();
      EXPECT_NEAR(elementary::sin(x), std::sin(x), 2 * unit * std::min(1.0, std::abs(x)));
      EXPECT_NEAR(elementary::cos(x), std::cos(x), 2 * unit);
      const double angle = std::atan2(y, x);
      EXPECT_NEAR(elementary::arctan(y, x), angle, 2 * unit * std::abs(angle));
    }
  }
  for (const double x : {-1.0, -0.0, 0.0, 1.0})
    for (const double y : {-1.0, -0.0, 0.0, 1.0})
      if (x != 0 || y != 0) {
        EXPECT_NEAR(std::abs(elementary::arctan(y, x)), std::abs(std::atan2(y, x)), 1e-15);
      }
}

/// The reduction of these would not be accurate, so it is refused.
TEST(Elementary, FunctionsAreNotANumberFarAway) {
  for (const double x : {1e7, -1e9, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(std::isnan(elementary::sin(x)));
    EXPECT_TRUE(std::isnan(elementary::cos(x)));
  }
}

using Anchor = std::array<double, anchor_size>;

elementary::TurnedAngle<double> turned(double y, double x, double before, Anchor& anchor) {
  return elementary::turned_angle<double>(y, x, before, anchor.data());
}

/// The anchor is none, the last angle, that of a while ago, or one turns away.
TEST(Elementary, AnglesStayNearTheirLastValue) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-40, 40), small(-0.2, 0.2), large(-3.1, 3.1),
      length(0.01, 100);
  Anchor kept{};
  int moved = 0;
  for (int i = 0; i < 20000; ++i) {
    const double angle = uniform(generator), r = length(generator),
                 before = angle + (i % 2 == 0 ? small(generator) : large(generator)),
                 at = angle + small(generator);
    Anchor none{}, near{at, std::sin(at), std::cos(at)};
    for (Anchor* const anchor : {&none, &near, &kept}) {
      const Anchor was = *anchor;
      const auto [q, sine, cosine] =
          turned(r * std::sin(angle), r * std::cos(angle), before, *anchor);
      EXPECT_NEAR(q, angle, 2e-14);
      EXPECT_NEAR(sine, std::sin(q), 1e-15);
      EXPECT_NEAR(cosine, std::cos(q), 1e-15);
      if (*anchor != was) {
        EXPECT_EQ((*anchor)[0], q);
      }
      moved += anchor == &near && *anchor != was;
    }
  }
  EXPECT_GT(moved, 5000);   // where `before` was far from it,
  EXPECT_LT(moved, 15000);  // and nowhere else
  Anchor none{};
  EXPECT_TRUE(std::isnan(turned(0, 0, 1, none).angle));
  EXPECT_TRUE(std::isnan(turned(1, 0, 1e8, none).angle));
  EXPECT_NEAR(turned(1, 0, 1, none).angle, std::numbers::pi / 2, 1e-15);  // after no number
}

/// An angle that goes on turning is evaluated anew now and then only, and stays as exact.
TEST(Elementary, AnchorsFollowTheirAngles) {
  Anchor anchor{};
  double last = 0;
  int moved = 0;
  for (int i = 1; i <= 10000; ++i) {
    const double angle = 0.01 * i, was = anchor[0];
    const auto [q, sine, cosine] = turned(std::sin(angle), std::cos(angle), last, anchor);
    EXPECT_NEAR(q, angle, 4e-14);
    EXPECT_NEAR(sine, std::sin(q), 4e-16);
    EXPECT_NEAR(cosine, std::cos(q), 4e-16);
    last = q;
    moved += anchor[0] != was;
  }
  EXPECT_LT(moved, 450);
}

}  // namespace
}  // namespace desmo::elementary_test
