// Points and vectors that follow from the basis of a body: geometry recomputed from solved points.

#include <gtest/gtest.h>

#include "tests/modelling/common.h"

namespace desmo::bodies_test {
namespace {

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
    const Mechanism mechanism = d.release_pinned();
    const Solved s(mechanism, turning, instants(2));
    expect_rigid_bodies(mechanism, s, 1e-11);
    for (int k = 0; k < s.instants() && !HasFailure(); ++k)
      expect_near(s.position(k, "B2"), s.position(k, "B"), 1e-13, "B2");
  }
}

/// Points and vectors that a spatial body is built on.
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
    const Mechanism mechanism = d.release();
    const Solved s(mechanism, motions, instants(0.5));
    expect_rigid_bodies(mechanism, s, 1e-10);
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
    const Mechanism mechanism = d.release_pinned();
    const Solved s(mechanism, turning, instants(1));
    EXPECT_EQ(s.model().structural_groups(), with_hanging_link ? 3 : 2);
    expect_rigid_bodies(mechanism, s, 1e-11);
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
    const Mechanism mechanism = d.release_pinned();
    const double start = by_angle ? 1 : std::cos(1);
    SCOPED_TRACE(by_angle ? "angle" : "component");
    const Solved s(mechanism, {Polynomial{{start, -0.5}}}, instants(0.5));
    EXPECT_EQ(s.model().structural_groups(), 2);
    expect_rigid_bodies(mechanism, s, 1e-11);
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
    Mechanism mechanism = d.release_pinned();
    if (kind == Guide::along_with_a_link) mechanism.bodies[block].length = 2;
    const ModellingResult modelled = model_mechanism(mechanism, turning);
    EXPECT_EQ(modelled.model.structural_groups(), 2);
    EXPECT_FALSE(std::ranges::any_of(modelled.left_out, &LeftOut::redundant));
    const Solved s(modelled.model, instants(1));
    for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
      const Vec from = polar(1, 1 + s.time(k)), way = unit(Vec{3, 0, 0} - from);
      expect_near(s.position(k, "u"), way, 1e-11, "u");
      expect_near(s.position(k, "E"), from + 5 * way, 1e-11, "E");
    }
  }
}

}  // namespace
}  // namespace desmo::bodies_test
