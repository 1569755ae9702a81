// Singular positions at which no determinant changes its sign, where closed forms say.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/extremes/rows.h"
#include "formulations/modelling/modelling.h"
#include "tests/checked/rows.h"
#include "tests/range/solved_start.h"

namespace desmo::double_root_test {
namespace {

constexpr double pi = std::numbers::pi;

using JointType = Mechanism::JointType;

/// A crank and rocker, whose rocker drives a second four-bar with links of that length and of 6.
/// Where crank and coupler are in line the rocker turns back, and the second one is in line, too:
/// its determinant goes like the angle of the rocker, which goes like the square of the crank's.
struct TwoFourBars {
  double crank = 2, coupler = 6, rocker = 5, ground = 7;
  double reach() const { return coupler + crank; }

  /// Returns the crank's angle in line with the coupler.
  double in_line() const {
    return std::acos((reach() * reach() + ground * ground - rocker * rocker) /
                     (2 * reach() * ground));
  }

  Model model(double start, double too_long = 0) const {
    const double x = reach() * std::cos(in_line()) - ground, y = reach() * std::sin(in_line()),
                 across = std::hypot(x, y);
    DyadChain chain = extremes::one_dyad(crank, start, ground, coupler, rocker);
    chain.dyads.push_back(closed_dyad(chain.dyads[0].joint,
                                      {ground + 6 * x / across, 6 * y / across, 0}, 6 + too_long,
                                      rocker, 1));
    MechanismBuilder builder("two_four_bars", 2);
    add(builder, chain);
    return model_mechanism(builder.release(), {Polynomial{{start}}}).model;
  }
};

/// They are interpolated from points that are neither too near nor too far.
TEST(DoubleRoots, OfAParallelogramWhoseCrankTurnsBackInLine) {
  const TwoFourBars bars;
  for (const double factor : {0.1, 1., 10.}) {
    RangeLimits limits;
    limits.sample_determinant *= factor;
    bool are_right = true;
    for (const double start : {bars.in_line() - 0.5, bars.in_line() + 0.01, bars.in_line() + 2.0}) {
      const Model m = bars.model(start);
      const DriverRange r = range_of(m, 0, limits);
      const double root = bars.in_line() + (start < bars.in_line() ? 0 : 2 * pi);
      are_right &= r.up.stop == RangeStop::full_turn && r.change_points.size() == 1 &&
                   std::abs(r.change_points[0].value - root) <= 1e-9;
      if (factor != 1 || !are_right) continue;
      EXPECT_TRUE(r.change_points[0].is_double) << start;
      EXPECT_EQ(m.groups[r.change_points[0].group].bodies,
                (std::vector<std::string>{"dyad2/coupler", "dyad2/rocker"}));
    }
    EXPECT_EQ(are_right, factor == 1) << factor;
  }
}

TEST(DoubleRoots, AreNoneWhereTheDeterminantStaysAway) {
  const TwoFourBars bars;
  for (const double too_long : {1e-2, 1e-4, 1e-6, 1e-12})
    EXPECT_TRUE(range_of(bars.model(1, too_long)).change_points.empty()) << too_long;
}

/// An elliptic trammel: a bar of length 3 with its ends on two axes, and a point on it that goes
/// along an ellipse with half axes of 2 and 1. A cylinder drives the point's distance from the
/// centre of curvature of its path at an angle, where it is stationary, but turns not back.
struct Trammel {
  static constexpr double a = 2, b = 1;

  /// Returns the radius of curvature.
  static double radius(double t) {
    const double c = a * std::sin(t), s = b * std::cos(t);
    return std::pow(c * c + s * s, 1.5) / (a * b);
  }

  Model model(double curvature_at, double start, double off = 0) const {
    const double c = std::cos(curvature_at), s = std::sin(curvature_at);
    const Mechanism::Vec centre{(a * a - b * b) / a * c * c * c + off,
                                (b * b - a * a) / b * s * s * s, 0},
        tip{a * std::cos(start), b * std::sin(start), 0};
    const double x = tip[0] - centre[0], y = tip[1] - centre[1], length = std::hypot(x, y);
    MechanismBuilder builder("trammel", 2);
    const int o = builder.point("O", {0, 0, 0}), foot = builder.point("C", centre),
              end_a = builder.point("A", {3 * std::cos(start), 0, 0}),
              end_b = builder.point("B", {0, 3 * std::sin(start), 0}), p = builder.point("P", tip),
              along_x = builder.vector("x", {1, 0, 0}), along_y = builder.vector("y", {0, 1, 0}),
              u = builder.vector("u", {x / length, y / length, 0});
    builder.carry(MechanismBuilder::ground, {o, foot}, {along_x, along_y});
    const int bar = builder.body("bar", {end_a, end_b, p}),
              cylinder = builder.body("cylinder", {foot}, {u}), rod = builder.body("rod", {p}, {u});
    builder.joint(JointType::revolute_on_slider, 0, bar, {o, end_a}, {along_x});
    builder.joint(JointType::revolute_on_slider, 0, bar, {o, end_b}, {along_y});
    builder.joint(JointType::revolute, 0, cylinder, {foot});
    builder.joint(JointType::prismatic, cylinder, rod, {foot, p}, {u});
    builder.joint(JointType::revolute, rod, bar, {p});
    builder.along("s", foot, p, u).driven = true;
    Mechanism mechanism = builder.release();
    mechanism.joints[1].name = "along y";
    return model_mechanism(mechanism, {Polynomial{{length}}}).model;
  }
};

TEST(DoubleRoots, OfACylinderFromACentreOfCurvature) {
  for (const double t : {0.6, 1.0}) {
    const DriverRange r = range_of(Trammel().model(t, t - 0.3));
    ASSERT_EQ(r.change_points.size(), 1u) << t;
    EXPECT_TRUE(r.change_points[0].is_double);
    EXPECT_NEAR(r.change_points[0].value, Trammel::radius(t), 1e-9) << t;
  }
}

TEST(DoubleRoots, BecomeDeadPointsOrNothingNextToThem) {
  int stops = 0, passes = 0;
  for (const double off : {-1e-3, 1e-3}) {
    const DriverRange r = range_of(Trammel().model(0.6, 0.3, off));
    EXPECT_TRUE(r.change_points.empty()) << off;
    const double nearest = std::min(std::abs(r.up.value - Trammel::radius(0.6)),
                                    std::abs(r.down.value - Trammel::radius(0.6)));
    (nearest < 0.01 ? stops : passes) += 1;
  }
  EXPECT_EQ(stops, 1);
  EXPECT_EQ(passes, 1);
}

/// With crank and rod of one length the slider goes along 2 r cos θ, or rests at the pivot: both
/// cross where the crank is upright.
TEST(DoubleRoots, AreNotTheCrossingsOfEqualCrankAndRod) {
  const DriverRange r = range_of(make_model(scene_file("scott_russell")));
  ASSERT_EQ(r.change_points.size(), 2u);
  EXPECT_NEAR(r.change_points[0].value, pi / 2, 1e-9);
  EXPECT_NEAR(r.change_points[1].value, 3 * pi / 2, 1e-9);
  for (const ChangePoint& point : r.change_points) EXPECT_FALSE(point.is_double);
}

}  // namespace
}  // namespace desmo::double_root_test
