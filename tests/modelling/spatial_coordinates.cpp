// Relative coordinates in space, recomputed from solved points.

#include <gtest/gtest.h>

#include "tests/modelling/common.h"

namespace desmo::coordinates_test {
namespace {

TEST(Coordinates, SpatialOnesMeasureGeometry) {
  // An arm that turns about y, and a sleeve that slides and turns on a shaft fixed to it.
  for (const double start : {0.3, 2.6, -0.8}) {
    Sketch d("arm and sleeve", 3);
    const int O = d.ground_point("O", {0.5, 1, 2}), F = d.ground_point("F", {-2, 0, 0});
    const int x = d.ground_vector("x", {1, 0, 0}), y = d.ground_vector("y", {0, 1, 0}),
              z = d.ground_vector("z", {0, 0, 1});
    const Vec o{0.5, 1, 2}, radial{std::cos(start), 0, std::sin(start)};
    const int P = d.point("P", o + 2 * radial), Q = d.point("Q", o + 2 * radial + Vec{0, 0.5, 0});
    const int r = d.vector("r", radial), n = d.vector("n", cross({0, 1, 0}, radial));
    const int S = d.point("S", o + 3 * radial), T = d.point("T", o + 3 * radial + Vec{0, 1, 0});
    const int b = d.vector("b", {0, 1, 0}), c = d.vector("c", cross({0, 1, 0}, radial));
    const int arm = d.body("arm", {O, P, Q}, {y, r, n}),
              sleeve = d.body("sleeve", {S, T}, {r, b, c});
    d.joint(JointType::revolute, Sketch::ground, arm, {O}, {y});
    d.joint(JointType::cylindrical, arm, sleeve, {P, S}, {r});
    d.spatial_angle("phi", line(O, P), x, z).driven = true;
    d.spatial_angle("spin", {b}, y, n).driven = true;
    d.spatial_angle("phi vector", {r}, x, z);
    d.spatial_angle("phi opposite", line(O, P), x, z).opposite = true;
    d.spatial_angle("phi vector opposite", {r}, x, z).opposite = true;
    d.component("sleeve x", S, 0);
    d.component("sleeve y", S, 1);
    d.component("sleeve z", S, 2);
    d.distance("reach", F, T);
    d.along("slide", P, S, r).driven = true;
    d.along("back", S, O, r);
    const Mechanism mechanism = d.release();
    const std::vector<double> times = instants(1);
    const Solved s(mechanism, {Polynomial{{start, 0.7}}, Polynomial{{0, 1}}, Polynomial{{1, 0.5}}},
                   times);
    expect_rigid_bodies(mechanism, s, 1e-10);
    for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
      const double t = times[k], phi = start + 0.7 * t;
      const Vec now{std::cos(phi), 0, std::sin(phi)}, sleeve_at = o + (3 + 0.5 * t) * now;
      expect_near(s.position(k, "r"), now, 1e-11, "r");
      expect_near(s.position(k, "S"), sleeve_at, 1e-11, "S");
      expect_same_angle(s.scalar(k, "phi vector"), phi, 1e-11, "phi vector");
      for (const char* name : {"phi opposite", "phi vector opposite"})
        expect_same_angle(s.scalar(k, name), std::atan2(now[2], -now[0]), 1e-11, name);
      const Vec up = s.position(k, "b");
      EXPECT_NEAR(up[1], std::cos(t), 1e-11);
      EXPECT_NEAR(dot(up, cross({0, 1, 0}, now)), std::sin(t), 1e-11);
      EXPECT_NEAR(s.scalar(k, "sleeve x"), sleeve_at[0], 1e-11);
      EXPECT_NEAR(s.scalar(k, "sleeve y"), sleeve_at[1], 1e-11);
      EXPECT_NEAR(s.scalar(k, "sleeve z"), sleeve_at[2], 1e-11);
      EXPECT_NEAR(s.scalar(k, "reach"), norm(s.position(k, "T") - Vec{-2, 0, 0}), 1e-11);
      EXPECT_NEAR(s.scalar(k, "back"), -(3 + 0.5 * t), 1e-11);
    }
  }
}

TEST(Coordinates, SpatialSlidingJointsHaveADistanceUnlessOneIsDeclared) {
  for (const bool declared : {false, true}) {
    Sketch d("slide", 3);
    const int O = d.ground_point("O", {0, 0, 0}), P = d.point("P", {2, 0, 0});
    const int x = d.ground_vector("x", {1, 0, 0}), z = d.ground_vector("z", {0, 0, 1});
    const int block = d.body("block", {P}, {x, z});
    d.joint(JointType::prismatic, Sketch::ground, block, {O, P}, {x, z});
    if (declared) d.along("s", P, O, x);  // either way round
    d.component("at", P, 0).driven = true;
    const Mechanism mechanism = d.release();
    const Solved s(mechanism, {Polynomial{{2, 1}}}, instants(0.5));
    const Model& m = s.model();
    const std::string automatic = mechanism.joints.front().name + "/distance";
    const bool present =
        std::ranges::find(m.entities, automatic, &Entity::name) != m.entities.end();
    ASSERT_EQ(present, !declared);
    EXPECT_NEAR(s.scalar(50, declared ? "s" : automatic), declared ? -2.5 : 2.5, 1e-12);
  }
}

}  // namespace
}  // namespace desmo::coordinates_test
