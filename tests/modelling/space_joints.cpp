// Joints in space that hold points on lines and planes: their equations. Closed forms of all
// formulations: tests/load/couplings.cpp.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "cases/io/files.h"
#include "tests/modelling/common.h"

namespace desmo::space_joints_test {
namespace {

constexpr double tolerance = 1e-12;

TEST(SpaceJoints, StateNoEquationTwice) {
  const Scene guides =
      read_scene(std::filesystem::path(DESMO_SOURCE_DIR) / "tests/load/scenes/guides.scene.json");
  const ModellingResult r = model_mechanism(guides.mechanism, guides.motions);
  EXPECT_TRUE(std::ranges::none_of(r.left_out, &LeftOut::redundant));
  const auto is_distance = [](const Constraint& c) {
    return c.name.ends_with(": distance from the plane") && kept_rows(c) == 1 &&
           constraint_kind_name(c.kind) == "projection3";
  };
  EXPECT_EQ(std::ranges::count_if(r.model.constraints, is_distance), 2);
}

TEST(PointOnPlane, MovesThePistonOfASwashPlate) {
  const double tilt = 0.3, r = 0.5, height = 0.2;
  Sketch d("swash plate", 3);
  const int O = d.ground_point("O", {0, 0, 0}), M = d.ground_point("M", {r, 0, 0});
  const int x = d.ground_vector("x", {1, 0, 0}), y = d.ground_vector("y", {0, 1, 0}),
            z = d.ground_vector("z", {0, 0, 1});
  const int n = d.vector("n", {std::sin(tilt), 0, std::cos(tilt)});
  const int P = d.point("P", {r, 0, height});
  const int plate = d.body("plate", {O}, {z, n}), piston = d.body("piston", {P}, {x, z});
  d.joint(JointType::revolute, Sketch::ground, plate, {O}, {z});
  d.joint(JointType::prismatic, Sketch::ground, piston, {M, P}, {z, x});
  d.joint(JointType::point_on_plane, plate, piston, {O, P}, {n});
  d.spatial_angle("theta", {n}, x, y).driven = true;
  const Solved s(d.release(), {Polynomial{{0, 3}}}, instants(2));
  for (int k = 0; k < s.instants(); ++k) {
    const double z_of_t = height + r * std::tan(tilt) * (1 - std::cos(3 * s.time(k)));
    expect_near(s.position(k, "P"), {r, 0, z_of_t}, tolerance, "P");
    const double rate = r * std::tan(tilt) * 3 * std::sin(3 * s.time(k));
    expect_near(s.velocity(k, "P"), {0, 0, rate}, tolerance, "velocity of P");
  }
}

constexpr double sizes_of_offsets[] = {0, 1e-11, 9e-7, -9e-7};

TEST(SlidingJoint, LeavesABodyBesideTheLineAsItIsDrawn) {
  for (const double off : sizes_of_offsets)
    for (const JointType type : {JointType::prismatic, JointType::cylindrical}) {
      Sketch d("beside the line", 3);
      const int O = d.ground_point("O", {0, 0, 0}), x = d.ground_vector("x", {1, 0, 0}),
                y = d.ground_vector("y", {0, 1, 0}), z = d.ground_vector("z", {0, 0, 1});
      const int P = d.point("P", {1, off, 0}), Q = d.point("Q", {1.2, 0.3, 0.4});
      const bool turns = type == JointType::cylindrical;
      const int v = turns ? d.vector("v", {0, 1, 0}) : y;
      d.joint(type, Sketch::ground, d.body("block", {P, Q}, {x, v}), {O, P},
              turns ? std::vector{x} : std::vector{x, v});
      d.along("s", P, O, x).driven = true;  // either way round
      if (turns) d.spatial_angle("turn", {v}, y, z).driven = true;
      std::vector<Motion> motions{Polynomial{{-1, -1}}};
      if (turns) motions.push_back(Polynomial{{0, 2}});
      const Solved s(d.release(), motions, instants(1));
      for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
        // The line leads through P.
        const double angle = turns ? 2 * s.time(k) : 0, c = std::cos(angle), n = std::sin(angle);
        const double b = 0.3 - off;
        expect_near(s.position(k, "P"), {1 + s.time(k), off, 0}, tolerance, "P");
        expect_near(s.position(k, "Q"), {1.2 + s.time(k), off + c * b - n * 0.4, n * b + c * 0.4},
                    tolerance, "Q");
      }
      EXPECT_FALSE(HasFailure()) << off;
    }
}

TEST(SlidingJoint, LeavesABodyBesideALineThatMovesAsItIsDrawn) {
  for (const double off : sizes_of_offsets)
    for (const bool is_first : {false, true}) {
      Sketch d("beside a line that moves", 3);
      const int O = d.ground_point("O", {0, 0, 0}), x = d.ground_vector("x", {1, 0, 0}),
                y = d.ground_vector("y", {0, 1, 0}), z = d.ground_vector("z", {0, 0, 1});
      const int u = d.vector("u", {1, 0, 0}), P = d.point("P", {2, off, -off});
      const int arm = d.body("arm", {O}, {u, z}), collar = d.body("collar", {P}, {u});
      d.joint(JointType::revolute, Sketch::ground, arm, {O}, {z});
      // Nothing tells how the collar is turned about the line.
      is_first ? d.joint(JointType::cylindrical, collar, arm, {P, O}, {u})
               : d.joint(JointType::cylindrical, arm, collar, {O, P}, {u});
      d.spatial_angle("theta", {u}, x, y).driven = true;
      d.along("s", O, P, u).driven = true;
      const Solved s(d.release(), {Polynomial{{0, 2}}, Polynomial{{2, 1}}}, instants(1));
      for (int k = 0; k < s.instants() && !HasFailure(); ++k)
        expect_near(s.position(k, "P"),
                    turned_about({0, 0, 1}, 2 * s.time(k), {2 + s.time(k), off, -off}), tolerance,
                    "P");
      EXPECT_FALSE(HasFailure()) << off << ", " << is_first;
    }
}

TEST(SlidingJoint, HasNoOffsetWhereNothingTellsItsSide) {
  Sketch d("strut", 3);
  const int O = d.ground_point("O", {0, 0, 0}), A = d.ground_point("A", {3, 0, 0}),
            x = d.ground_vector("x", {1, 0, 0}), y = d.ground_vector("y", {0, 1, 0}),
            z = d.ground_vector("z", {0, 0, 1});
  const int B = d.point("B", {1, 0, 0}), u = d.vector("u", unit(Vec{-1, 0, 4e-7}));
  const int v = d.vector("v", {1, 0, 0});
  const int crank = d.body("crank", {O, B}, {z, v}), cylinder = d.body("cylinder", {A}, {u}),
            rod = d.body("rod", {B}, {u});
  d.joint(JointType::revolute, Sketch::ground, crank, {O}, {z});
  d.joint(JointType::spherical, Sketch::ground, cylinder, {A});
  d.joint(JointType::cylindrical, cylinder, rod, {A, B}, {u}, "strut");
  d.joint(JointType::spherical, crank, rod, {B});
  d.spatial_angle("theta", {v}, x, y).driven = true;
  const Solved s(d.release(), {Polynomial{{0, 2}}}, instants(1));
  for (int k = 0; k < s.instants() && !HasFailure(); ++k)
    EXPECT_NEAR(s.scalar(k, "strut/distance"), norm(polar(1, 2 * s.time(k)) - Vec{3, 0, 0}),
                tolerance);
}

TEST(Hinge, NeedsTwoPlaces) {
  Sketch d("door", 3);
  const int H1 = d.ground_point("H1", {0, 0, 1}), H2 = d.ground_point("H2", {0, 0, 1}),
            L = d.point("L", {1, 0, 0});
  d.joint(JointType::hinge, Sketch::ground, d.body("door", {H1, H2, L}), {H1, H2}, {}, "hinge");
  expect_refused(d.release(), {}, {"joint 'hinge': its points 'H1' and 'H2' coincide"});
}

}  // namespace
}  // namespace desmo::space_joints_test
