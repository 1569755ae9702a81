// Welded bodies, given lengths, and what follows from a body: geometry recomputed from solved
// points.

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
  const std::vector<double> times = instants(1);
  const Solved s(d.release_pinned(), {Polynomial{{0, 1}}}, times);
  for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
    expect_near(s.position(k, "P"), polar(3, times[k]), 1e-12, "P");
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

// ---- derived points and vectors ----

TEST(Derived, CouplerPointsAndVectorsFollowRigidly) {
  // The same body built on a line and on a vector; Q is on that line, B2 where B
  // is.
  for (const bool on_vector : {false, true}) {
    Sketch d("coupler curve", 2);
    const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
    const Vec b = polar(1, 1), c{3.2, 2.9, 0};
    const int B = d.point("B", b), C = d.point("C", c), P = d.point("P", {1.5, 3.1, 0}),
              Q = d.point("Q", 0.3 * b + 0.7 * c), B2 = d.point("B2", b);
    std::vector<int> vectors{d.vector_along("e", unit(c - b), B, C),
                             d.vector_along("f", unit(Vec{1.5, 3.1, 0} - c), C, P)};
    if (on_vector) vectors.push_back(d.vector("v", polar(1, 0.4)));
    if (on_vector) vectors.push_back(d.vector("w", polar(1, -2)));
    d.bodies({{"crank", {A, B}}, {"rocker", {D, C}}, {"coupler", {B, C, P, Q, B2}, vectors}});
    d.angle("theta", line(A, B)).driven = true;
    const Mechanism described = d.release_pinned();
    const Solved s(described, turning, instants(2));
    expect_rigid_bodies(described, s, 1e-11);
    for (int k = 0; k < s.instants() && !HasFailure(); ++k)
      expect_near(s.position(k, "B2"), s.position(k, "B"), 1e-13, "B2");
  }
}

/// What a spatial body is built on.
struct SpatialBody {
  const char* name;
  std::vector<Vec> points, vectors;
};

TEST(Derived, SpatialBodiesFollowRigidlyWhateverTheyAreBuiltOn) {
  // A free body, driven by six components of three of its points, which come last in one case so
  // that they are derived.
  const Vec o{1, 2, 3}, p{2, 2.2, 3.1}, q{1.3, 3, 2.8},
      in_plane = o + 0.4 * (p - o) + 0.3 * (q - o), on_line = o + 0.25 * (p - o),
      out{1.4, 2.1, 4.2}, farther{0, 1, 2};
  const Vec u = unit({1, 2, -1}), v = unit({0.2, -1, 0.5}), w = unit({-1, 0.3, 2}),
            n = unit(cross(p - o, q - o)), in_plane_vector = unit(p - q);
  const SpatialBody bodies[] = {
      {"three points", {o, p, q, in_plane, on_line}, {}},
      {"three points, and one out of their plane", {o, p, q, in_plane, out, farther}, {}},
      {"three points and vectors", {o, p, q, out}, {n, in_plane_vector, u}},
      {"two points and a vector", {o, p, q, in_plane, out}, {u}},
      {"two points and a vector along them", {o, p, q, out}, {unit(p - o), v}},
      {"a point and two vectors", {o, p, q, out}, {u, v}},
      {"a point and three vectors", {o, on_line, p, q, out, farther}, {u, v, w, n}},
      {"vectors normal to each other", {o, p, q}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
      {"the driven points last", {farther, out, on_line, o, p, q}, {}},
  };
  for (const SpatialBody& b : bodies) {
    Sketch d(b.name, 3);
    std::vector<int> points, vectors;
    int driven_points[3] = {};
    for (const Vec& at : b.points) {
      points.push_back(d.point("p" + std::to_string(points.size()), at));
      for (int i = 0; i < 3; ++i)
        if (at == (i == 0 ? o : i == 1 ? p : q)) driven_points[i] = points.back();
    }
    for (const Vec& direction : b.vectors)
      vectors.push_back(d.vector("v" + std::to_string(vectors.size()), direction));
    vectors.push_back(
        d.vector_along("along", unit(b.points[2] - b.points[1]), points[1], points[2]));
    d.ground_point("origin", {0, 0, 0});
    d.body("body", points, vectors);
    std::vector<Motion> motions;
    const auto drive = [&](int of, int axis, double from, double rate) {
      d.component("c" + std::to_string(motions.size()), driven_points[of], axis).driven = true;
      motions.push_back(Polynomial{{from, rate}});
    };
    drive(0, 0, o[0], 0.3), drive(0, 1, o[1], -0.2), drive(0, 2, o[2], 0.1);
    drive(1, 1, p[1], 0.25), drive(1, 2, p[2], -0.35), drive(2, 2, q[2], 0.2);
    const Mechanism described = d.release();
    const Solved s(described, motions, instants(0.5));
    expect_rigid_bodies(described, s, 1e-10);
    EXPECT_NEAR(s.position(50, "p0")[0], b.points[0] == o ? o[0] + 0.15 : s.position(50, "p0")[0],
                1e-12);
    if (HasFailure()) FAIL() << b.name;
  }
}

TEST(Derived, PointOfTwoBodiesBeyondTheBasisOfBoth) {
  // The pin P of two ternary links is listed last by each; a third link hangs on it and builds on
  // it. Whoever finds P, its two relations hold the first two links together.
  for (const bool with_hanging_link : {false, true}) {
    Sketch d("shared pin", 2);
    const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
    const int B = d.point("B", polar(1, 1)), Q = d.point("Q", {1, 2, 0}),
              R = d.point("R", {4, 2, 0}), P = d.point("P", {3.2, 2.9, 0});
    d.bodies({{"crank", {A, B}}, {"coupler", {B, Q, P}}, {"rocker", {D, R, P}}});
    if (with_hanging_link) {
      const int E = d.ground_point("E", {7, 0, 0}), F = d.point("F", {6, 3, 0});
      d.bodies({{"hanging", {P, F}}, {"last", {E, F}}});
    }
    d.angle("theta", line(A, B)).driven = true;
    const Mechanism described = d.release_pinned();
    const Solved s(described, turning, instants(1));
    EXPECT_EQ(s.model().structural_groups(), with_hanging_link ? 3 : 2);
    expect_rigid_bodies(described, s, 1e-11);
  }
}

TEST(Derived, DriverOfAPointThatALaterGroupBuildsOn) {
  // The crank's basis is its mark M; its end B, which the coupler builds on, is driven.
  for (const bool by_angle : {true, false}) {
    Sketch d("marked crank", 2);
    const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
    const int M = d.point("M", {0.3, 0.1, 0}), B = d.point("B", polar(1, 1)),
              C = d.point("C", {3.2, 2.9, 0});
    d.bodies({{"crank", {A, M, B}}, {"coupler", {B, C}}, {"rocker", {D, C}}});
    if (by_angle)
      d.angle("drive", line(A, B)).driven = true;
    else
      d.component("drive", B, 0).driven = true;
    const Mechanism described = d.release_pinned();
    const double start = by_angle ? 1 : std::cos(1);
    SCOPED_TRACE(by_angle ? "angle" : "component");
    const Solved s(described, {Polynomial{{start, -0.5}}}, instants(0.5));
    EXPECT_EQ(s.model().structural_groups(), 2);
    expect_rigid_bodies(described, s, 1e-11);
  }
}

TEST(Derived, SliderOnAVectorAlongAnotherBodysSegment) {
  // The guide's vector follows from the guide's points. The block that shares it has not both of
  // them: it still turns with the guide, and its own length is not that of the guide's line.
  enum class Guide { vector, along, along_with_a_link };
  for (const Guide kind : {Guide::vector, Guide::along, Guide::along_with_a_link}) {
    Sketch d("swinging block", 2);
    const int A = d.ground_point("A", {0, 0, 0}), O = d.ground_point("O", {3, 0, 0});
    const Vec b = polar(1, 1), direction = unit(Vec{3, 0, 0} - b);
    const int B = d.point("B", b), E = d.point("E", b + 5 * direction);
    const int u =
        kind == Guide::vector ? d.vector("u", direction) : d.vector_along("u", direction, B, E);
    d.body("crank", {A, B});
    const int guide = d.body("guide", {B, E}, {u});
    const int block = d.body("block", {O}, {u});
    if (kind == Guide::along_with_a_link) {
      const int F = d.point("F", Vec{3, 0, 0} + polar(2, 1.5));
      d.carry(block, {F});
    }
    d.joint(JointType::prismatic, guide, block, {B, O}, {u});
    d.angle("theta", line(A, B)).driven = true;
    SCOPED_TRACE(static_cast<int>(kind));
    Mechanism described = d.release_pinned();
    if (kind == Guide::along_with_a_link) described.bodies[block].length = 2;
    const std::vector<double> times = instants(1);
    const ModellingResult modelled = model_mechanism(described, turning);
    EXPECT_EQ(modelled.model.structural_groups(), 2);
    EXPECT_FALSE(std::ranges::any_of(modelled.left_out, &LeftOut::redundant));
    const Solved s(modelled.model, times);
    for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
      const Vec from = polar(1, 1 + times[k]), way = unit(Vec{3, 0, 0} - from);
      expect_near(s.position(k, "u"), way, 1e-11, "u");
      expect_near(s.position(k, "E"), from + 5 * way, 1e-11, "E");
    }
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
