// What an angle in space measures of a direction that does not lie in its plane.

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "tests/describing.h"

namespace desmo::spatial_angles_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

TEST(SpatialAngle, OfACrankPinBesideItsPivotDrives) {
  Sketch d("crank pin off the plane", 3);
  const int x = d.ground_vector("x", {1, 0, 0}), y = d.ground_vector("y", {0, 1, 0}),
            z = d.ground_vector("z", {0, 0, 1});
  const int A = d.ground_point("A", {0, 0, 0}), B = d.point("B", {0.1, 0, 0.02}),
            C = d.point("C", {0.35, 0.19, 0.02}), D = d.ground_point("D", {0.3, 0, 0});
  d.bodies({{"crank", {A, B}, {z}}, {"rod", {B, C}, {z}}, {"rocker", {D, C}, {z}}});
  d.spatial_angle("theta", line(A, B), x, y).driven = true;
  const Solved s(d.release_pinned({z}), {Polynomial{{0, 30 * degree}}}, instants(1));
  const int last = s.instants() - 1;
  expect_near(s.position(last, "B"), polar(0.1, 30 * degree) + Vec{0, 0, 0.02}, 1e-13, "B");
  expect_near(s.position(last, "C"), {0.370953173831, 0.183209298681, 0.02}, 1e-12, "C");
}

/// The corner of a car with its toe and camber: the wheel's spin axis lies in no plane of the
/// frame.
TEST(SpatialAngle, IsThatOfTheProjectionOntoItsPlane) {
  Sketch d("corner", 3);
  const int x = d.ground_vector("x", {1, 0, 0}), y = d.ground_vector("y", {0, 1, 0}),
            z = d.ground_vector("z", {0, 0, 1});
  const int UF = d.ground_point("UF", {0.07, 0.185, 0.29}),
            LF = d.ground_point("LF", {0.11, 0.115, 0.095}),
            TI = d.ground_point("TI", {-0.08, 0.15, 0.0933});
  const int UO = d.point("UO", {-0.012, 0.53, 0.312}), LO = d.point("LO", {0.01, 0.59, 0.072}),
            TO = d.point("TO", {-0.07, 0.555, 0.0739}), WC = d.point("WC", {0, 0.61, 0.254});
  const int axis = d.ground_vector("axis", {1, 0, 0});
  const int spin =
      d.vector("spin", {0.0017442651590149978, 0.9993893048602067, 0.03489949670250097});
  const int upper = d.body("upper", {UF, UO}, {axis}), lower = d.body("lower", {LF, LO}, {axis}),
            upright = d.body("upright", {UO, LO, TO, WC}, {spin}), tie = d.body("tie", {TI, TO});
  d.joint(JointType::revolute, Sketch::ground, upper, {UF}, {axis});
  d.joint(JointType::revolute, Sketch::ground, lower, {LF}, {axis});
  d.joint(JointType::spherical, upper, upright, {UO});
  d.joint(JointType::spherical, lower, upright, {LO});
  d.joint(JointType::spherical, Sketch::ground, tie, {TI});
  d.joint(JointType::spherical, tie, upright, {TO});
  d.component("height", WC, 2).driven = true;
  d.spatial_angle("camber", {spin}, y, z);
  d.spatial_angle("toe", {spin}, y, x);
  const Solved s(d.release(), {Polynomial{{0.224, 0.06}}}, instants(1));
  for (int k = 0; k < s.instants(); ++k) {
    const Vec axle = s.position(k, "spin");
    EXPECT_NEAR(s.scalar(k, "camber"), std::atan2(axle[2], axle[1]), 1e-12);
    EXPECT_NEAR(s.scalar(k, "toe"), std::atan2(axle[0], axle[1]), 1e-12);
  }
  const int last = s.instants() - 1;
  EXPECT_NEAR(s.scalar(0, "camber") / degree, 1.275371, 1e-6);
  EXPECT_NEAR(s.scalar(last, "camber") / degree, 2.842949, 1e-6);
  EXPECT_NEAR(s.scalar(0, "toe") / degree, 0.009755, 1e-6);
  EXPECT_NEAR(s.scalar(last, "toe") / degree, -0.001399, 1e-6);
}

/// An arm that turns about z, with the angle of a direction that is that far from its axis.
Mechanism arm_with_angle(double sine, bool of_line) {
  Sketch d("arm", 3);
  const int x = d.ground_vector("x", {1, 0, 0}), y = d.ground_vector("y", {0, 1, 0}),
            z = d.ground_vector("z", {0, 0, 1});
  const Vec w{0, sine, std::sqrt(1 - sine * sine)};
  const int O = d.ground_point("O", {0, 0, 0}), P = d.point("P", {1, 0, 0}),
            Q = d.point("Q", Vec{1, 0, 0} + w), v = d.vector("v", w);
  d.body("arm", {O, P, Q}, {z, v});
  d.spatial_angle("theta", line(O, P), x, y).driven = true;
  d.spatial_angle("phi", of_line ? line(P, Q) : Mechanism::Direction{v}, x, y);
  return d.release_pinned({z});
}

TEST(SpatialAngle, IsRefusedWhereTheProjectionVanishes) {
  const std::vector<Motion> motions{Polynomial{{0, 1}}};
  for (const double sine : {0.0, 5e-7}) {
    expect_refused(arm_with_angle(sine, false), motions,
                   {"coordinate 'phi': 'v' is perpendicular to the plane of 'x' and 'y'",
                    "projection", "choose another direction"});
    expect_refused(arm_with_angle(sine, true), motions, {"'phi': the line from 'P' to 'Q' is per"});
  }
  for (const bool of_line : {false, true}) {
    const Solved s(arm_with_angle(5e-6, of_line), motions, std::array{0., 0.1});
    EXPECT_NEAR(s.scalar(1, "phi"), std::numbers::pi / 2 + 0.1, 1e-8);
  }
}

}  // namespace
}  // namespace desmo::spatial_angles_test
