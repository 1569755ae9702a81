// Welded bodies and given lengths: geometry recomputed from solved points.

#include <gtest/gtest.h>

#include "tests/modelling/common.h"

namespace desmo::bodies_test {
namespace {

/// A four-bar whose coupler carries a point P; `split` says how: in one body, or welded ones.
enum class Coupler { whole, two, three };
Mechanism welded_coupler(Coupler split) {
  Sketch d("welded", 2);
  const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
  const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0}),
            P = d.point("P", {1.5, 3.1, 0}), v = d.vector("v", polar(1, 0.4));
  d.bodies({{"crank", {A, B}}, {"rocker", {D, C}}});
  int at_crank = 0, at_rocker = 0;
  if (split == Coupler::whole) {
    at_crank = at_rocker = d.body("coupler", {B, C, P}, {v});
  } else if (split == Coupler::two) {
    at_crank = d.body("front", {B, P});
    at_rocker = d.body("back", {C}, {v});
    d.weld(at_rocker, at_crank);
  } else {
    // Welded in a chain whose order is not that of the bodies.
    at_crank = d.body("front", {B});
    at_rocker = d.body("back", {C}, {v});
    const int middle = d.body("middle", {P});
    d.weld(middle, at_rocker);
    d.weld(middle, at_crank);
  }
  d.angle("theta", line(A, B)).driven = true;
  return d.release_pinned();
}

TEST(FixedJoint, WeldedBodiesMoveAsTheirMergedBodyDoes) {
  const std::vector<double> times = instants(2);
  const Mechanism whole = welded_coupler(Coupler::whole);
  const Solved expected(whole, turning, times);
  expect_rigid_bodies(whole, expected, 1e-11);
  for (const Coupler split : {Coupler::two, Coupler::three}) {
    const Solved actual(welded_coupler(split), turning, times);
    EXPECT_EQ(actual.model().coordinates(), expected.model().coordinates());
    EXPECT_EQ(actual.model().structural_groups(), 2);
    for (int k = 0; k < expected.instants() && !HasFailure(); ++k)
      for (const char* name : {"B", "C", "P", "v"}) {
        expect_near(actual.position(k, name), expected.position(k, name), 1e-12, name);
        expect_near(actual.acceleration(k, name), expected.acceleration(k, name), 1e-10, name);
      }
  }
}

TEST(FixedJoint, BodyFixedToTheGroundIsGround) {
  Sketch d("bracketed", 2);
  const int A = d.ground_point("A", {0, 0, 0});
  const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0}),
            D = d.point("D", {4, 0, 0}), E = d.point("E", {4, 1, 0});
  d.bodies({{"crank", {A, B}}, {"coupler", {B, C}}, {"rocker", {D, C}}});
  const int bracket = d.body("bracket", {E}), foot = d.body("foot", {D});
  d.weld(bracket, foot);  // through another body, and found after it
  d.weld(bracket, Sketch::ground);
  d.angle("theta", line(A, B)).driven = true;
  const std::vector<double> times = instants(1);
  const Solved actual(d.release_pinned(), turning, times);
  const Solved expected(driven(four_bar_sketch().release_pinned(), {"theta"}), turning, times);
  const Model& m = actual.model();
  EXPECT_TRUE(m.entities[m.find("D")].fixed);
  EXPECT_TRUE(m.entities[m.find("E")].fixed);
  for (int k = 0; k < expected.instants() && !HasFailure(); ++k)
    expect_near(actual.position(k, "C"), expected.position(k, "C"), 1e-12, "C");
}

TEST(FixedJoint, GivenLengthIsThatOfItsOwnLinkOnly) {
  // A link of given length welded to a plate: the plate keeps its own dimensions.
  Sketch d("welded link", 2);
  const int O = d.ground_point("O", {0, 0, 0});
  const int P = d.point("P", {3, 0, 0}), A = d.point("A", {0, 1, 0}), B = d.point("B", {1, 1, 0});
  const int plate = d.body("plate", {O, P}), link = d.link("link", A, B, 1);
  d.weld(plate, link);
  d.angle("theta", line(O, P)).driven = true;
  const Solved s(d.release_pinned(), {Polynomial{{0, 1}}}, instants(1));
  for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
    expect_near(s.position(k, "P"), polar(3, s.time(k)), 1e-12, "P");
    EXPECT_NEAR(norm(s.position(k, "B") - s.position(k, "A")), 1, 1e-12);
  }
}

// ---- dimensions given as lengths ----

TEST(Length, IsKeptByALinkThatCarriesAVectorToo) {
  // The vector may be the basis of the link's coordinates; its two points are still that far apart.
  for (const bool with_vector : {false, true}) {
    Sketch d = four_bar_sketch(3.1);
    if (with_vector) d.carry(2, {}, {d.vector("v", polar(1, 0.7))});  // the coupler
    const Solved s(driven(d.release_pinned(), {"theta"}), turning, instants(1));
    for (int k = 0; k < s.instants() && !HasFailure(); ++k)
      EXPECT_NEAR(norm(s.position(k, "C") - s.position(k, "B")), 3.1, 1e-12)
          << (with_vector ? "with" : "without") << " a vector";
  }
}

/// With a length that is one unit in the last place short, a mechanism with an exact change point
/// has none.
TEST(GivenLength, IsKeptToTheLastBit) {
  Sketch d("crank", 2);
  const int O = d.ground_point("O", {0, 0, 0}), M = d.point("M", {0.5, 0.8, 0});
  d.link("crank", O, M, 1);
  d.angle("theta", line(O, M)).driven = true;
  const Model m = model_mechanism(d.release_pinned(), turning).model;
  int lengths = 0;
  for (const Constraint& c : m.constraints)
    for (const double constant : values_of(c)) {
      EXPECT_EQ(constant, 1) << c.name;
      ++lengths;
    }
  EXPECT_GE(lengths, 1);
}

}  // namespace
}  // namespace desmo::bodies_test
