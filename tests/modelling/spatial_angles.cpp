// Angles in space of directions that do not lie in their plane.

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
