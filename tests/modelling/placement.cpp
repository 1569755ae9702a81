// The order of a body's points and vectors decides what its basis is, never what is solved.

#include <gtest/gtest.h>

#include "tests/modelling/common.h"

namespace desmo::placement_test {
namespace {

constexpr double speed = -0.5;  // of all cranks [rad/s]

/// Returns the motion of a crank that is drawn at an angle [rad].
std::vector<Motion> turning_from(double angle) { return {Polynomial{{angle, speed}}}; }
const std::vector<double> times = instants(0.5, 0.1);

/// A point or vector by its name, and as it is drawn.
struct AsDrawn {
  std::string name;
  Vec at;
};

/// Expects bodies to be rigid, and a point to turn with its crank.
void expect_motion(const Mechanism& described, const Solved& s, const AsDrawn& point) {
  expect_rigid_bodies(described, s, 1e-10);
  for (int k = 0; k < s.instants(); ++k)
    expect_near(s.position(k, point.name), turned_about({0, 0, 1}, speed * s.time(k), point.at),
                1e-12, point.name);
}

/// Expects a point q to keep its distance from the line through p along u.
void expect_slot(const Solved& s, const AsDrawn& u, const AsDrawn& p, const AsDrawn& q) {
  for (int k = 0; k < s.instants(); ++k)
    EXPECT_NEAR(cross(s.position(k, u.name), s.position(k, q.name) - s.position(k, p.name))[2],
                cross(u.at, q.at - p.at)[2], 1e-12);
}

/// Adds a rod from a crank's point B to a lever K-G. It makes B part of the basis of a later body
/// than the crank.
void add_lever(Sketch& d, int B) {
  const int K = d.point("K", {2.5, 0.5, 0}), G = d.ground_point("G", {3, -1, 0});
  d.bodies({{"rod", {B, K}}, {"lever", {G, K}}});
}

const Vec drawn_b{1.5, 1, 0}, drawn_c{1.2, -0.5, 0}, rocker_pivot{0, -1, 0};
const Vec drawn_slot = unit(Vec{0.2, 1, 0});

/// A crank of which B is in the basis or not. A rocker ends in the crank's slot, through B along u.
/// Later a lever hangs on B.
Mechanism slotted(bool b_first, bool with_block) {
  Sketch d("slotted", 2);
  const int O = d.ground_point("O", {0, 0, 0}), Q = d.ground_point("Q", rocker_pivot);
  const int A = d.point("A", {1, 0, 0}), B = d.point("B", drawn_b), C = d.point("C", drawn_c);
  const int u = d.vector("u", drawn_slot);
  const int crank = d.body("crank", b_first ? std::vector{B, O, A} : std::vector{O, A, B}, {u});
  const int rocker = d.body("rocker", {Q, C});
  if (with_block)
    d.joint(JointType::prismatic, crank, d.body("block", {C}, {u}), {B, C}, {u});
  else
    d.joint(JointType::revolute_on_slider, crank, rocker, {B, C}, {u});
  add_lever(d, B);
  d.angle("a", line(O, A)).driven = true;
  return d.release_pinned();
}

TEST(Placement, ASlotReadsAPointThatLaterBodiesShare) {
  for (const bool b_first : {false, true})
    for (const bool with_block : {false, true}) {
      const Mechanism described = slotted(b_first, with_block);
      const Solved s(described, turning_from(0), times);
      EXPECT_EQ(s.model().structural_groups(), 3);
      expect_motion(described, s, {"B", drawn_b});
      expect_slot(s, {"u", drawn_slot}, {"B", drawn_b}, {"C", drawn_c});
    }
}

TEST(Placement, AGuideReadsAPointThatLaterBodiesShare) {
  // With and without the declared distance, which would define the guide.
  for (const bool c_first : {false, true})
    for (const bool declared : {false, true}) {
      Sketch d("two rods on a slider", 2);
      const int O = d.ground_point("O", {0, 0, 0}), G = d.ground_point("G", {3, -0.4, 0});
      const int A = d.point("A", {0.3, 0.4, 0}), B = d.point("B", {1.5, 0, 0}),
                C = d.point("C", {2, 0, 0}), E = d.point("E", {2.8, 0.6, 0});
      const int x = d.ground_vector("x", {1, 0, 0});
      d.bodies({{"crank", {O, A}}, {"rod", {A, B}}});
      const int slider = d.body("slider", c_first ? std::vector{C, B} : std::vector{B, C}, {x});
      d.bodies({{"link", {C, E}}, {"lever", {E, G}}});
      d.joint(JointType::prismatic, Sketch::ground, slider, {O, C}, {x});
      if (declared) d.along("s", O, C, x);
      const double start = std::atan2(4, 3);
      d.angle("a", line(O, A)).driven = true;
      const Mechanism described = d.release_pinned();
      const Solved s(described, turning_from(start), times);
      expect_motion(described, s, {"A", {0.3, 0.4, 0}});
      for (int k = 0; k < s.instants(); ++k) {
        const Vec C = s.position(k, "C");
        EXPECT_NEAR(C[1], 0, 1e-12);
        if (declared) {
          EXPECT_NEAR(s.scalar(k, "s"), C[0], 1e-12);
        }
      }
    }
}

TEST(Placement, ASlotReadsAVectorAlongAPointThatLaterBodiesShare) {
  // The slot reads w, which follows from A and B. Only its definition reads B.
  for (const bool b_first : {false, true}) {
    Sketch d("along", 2);
    const int O = d.ground_point("O", {0, 0, 0}), Q = d.ground_point("Q", rocker_pivot);
    const Vec drawn_a{1, 0, 0}, drawn_w = unit(drawn_b - drawn_a);
    const int A = d.point("A", drawn_a), B = d.point("B", drawn_b), C = d.point("C", drawn_c);
    const int w = d.vector_along("w", drawn_w, A, B);
    const int crank = d.body("crank", b_first ? std::vector{B, O, A} : std::vector{O, A, B}, {w});
    const int rocker = d.body("rocker", {Q, C});
    d.joint(JointType::revolute_on_slider, crank, rocker, {A, C}, {w});
    add_lever(d, B);
    d.angle("a", line(O, A)).driven = true;
    const Mechanism described = d.release_pinned();
    const Solved s(described, turning_from(0), times);
    expect_motion(described, s, {"B", drawn_b});
    expect_slot(s, {"w", drawn_w}, {"A", drawn_a}, {"C", drawn_c});
  }
}

TEST(Placement, ASlotReadsAVectorThatALaterBlockShares) {
  for (const bool v_first : {false, true}) {
    Sketch d("block on a slot", 2);
    const int O = d.ground_point("O", {0, 0, 0}), Q = d.ground_point("Q", rocker_pivot),
              G = d.ground_point("G", {3, 0.5, 0});
    const int A = d.point("A", {1, 0, 0}), C = d.point("C", drawn_c), P = d.point("P", {1.2, 1, 0});
    const int u = d.vector("u", {1, 0, 0}), v = d.vector("v", drawn_slot);
    const int crank = d.body("crank", {O, A}, v_first ? std::vector{v, u} : std::vector{u, v});
    const int rocker = d.body("rocker", {Q, C});
    d.joint(JointType::revolute_on_slider, crank, rocker, {A, C}, {v});
    const int block = d.body("block", {P}, {v});
    d.body("rod", {P, G});
    d.joint(JointType::prismatic, crank, block, {A, P}, {v});
    d.angle("a", line(O, A)).driven = true;
    const Mechanism described = d.release_pinned();
    const Solved s(described, turning_from(0), times);
    EXPECT_EQ(s.model().structural_groups(), 3);
    const AsDrawn crank_end{"A", {1, 0, 0}};
    expect_motion(described, s, crank_end);
    expect_slot(s, {"v", drawn_slot}, crank_end, {"C", drawn_c});
    expect_slot(s, {"v", drawn_slot}, crank_end, {"P", {1.2, 1, 0}});
  }
}

TEST(Placement, APlaneInSpaceReadsAPointThatLaterBodiesShare) {
  // A rocker's plane rests on the crank's point B. A rod with spherical ends leads from B to a
  // lever half a metre above.
  for (const bool b_first : {false, true}) {
    Sketch d("plane", 3);
    const int x = d.ground_vector("x", {1, 0, 0}), y = d.ground_vector("y", {0, 1, 0}),
              z = d.ground_vector("z", {0, 0, 1});
    const int O = d.ground_point("O", {0, 0, 0}), Q = d.ground_point("Q", rocker_pivot);
    const int A = d.point("A", {1, 0, 0}), S = d.point("S", {0, 1, 0}), B = d.point("B", drawn_b),
              C = d.point("C", drawn_c), n = d.vector("n", drawn_slot);
    const int crank =
        d.body("crank", b_first ? std::vector{O, B, S, A} : std::vector{O, A, S, B}, {z});
    const int rocker = d.body("rocker", {Q, C}, {z, n});
    const int K = d.point("K", {2.5, 0.5, 0.5}), G = d.ground_point("G", {3, -1, 0.5});
    const int rod = d.body("rod", {B, K}), lever = d.body("lever", {G, K}, {z});
    d.joint(JointType::revolute, Sketch::ground, crank, {O}, {z});
    d.joint(JointType::revolute, Sketch::ground, rocker, {Q}, {z});
    d.joint(JointType::point_on_plane, rocker, crank, {C, B}, {n});
    d.joint(JointType::spherical, crank, rod, {B});
    d.joint(JointType::spherical, rod, lever, {K});
    d.joint(JointType::revolute, Sketch::ground, lever, {G}, {z});
    d.spatial_angle("a", line(O, A), x, y).driven = true;
    const Mechanism described = d.release();
    const Solved s(described, turning_from(0), times);
    EXPECT_EQ(s.model().structural_groups(), 3);
    expect_motion(described, s, {"B", drawn_b});
    for (int k = 0; k < s.instants(); ++k)
      EXPECT_NEAR(dot(s.position(k, "n"), s.position(k, "B") - s.position(k, "C")),
                  dot(drawn_slot, drawn_b - drawn_c), 1e-12);
  }
}

}  // namespace
}  // namespace desmo::placement_test
