// Relative coordinates in the plane, recomputed from solved points, and as drivers.

#include <gtest/gtest.h>

#include "tests/modelling/common.h"

namespace desmo::coordinates_test {
namespace {

TEST(Coordinates, PlanarOnesMeasureGeometry) {
  Sketch d("measured", 2);
  const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
  const int x = d.ground_vector("x", {1, 0, 0}), g = d.ground_vector("g", polar(1, 2.1));
  const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0}),
            P = d.point("P", {1.5, 3.1, 0}), R = d.point("R", {4.5, 1.4, 0});
  const int v = d.vector("v", polar(1, 0.4)), w = d.vector("w", polar(1, -1.2));
  d.bodies({{"crank", {A, B}}, {"coupler", {B, C, P}, {v}}, {"rocker", {D, C, R}, {w}}});
  // A piston on a rod behind the rocker, and a sleeve at the far end of the line.
  const int S = d.point("S", {8, 0, 0}), slider_rod = d.body("slider rod", {R, S});
  d.joint(JointType::revolute_on_slider, Sketch::ground, slider_rod, {D, S}, {x});
  d.angle("theta", line(A, B)).driven = true;
  const Mechanism::Direction AB = line(A, B), BC = line(B, C), CB = line(C, B), BP = line(B, P),
                             DC = line(D, C), DR = line(D, R);
  using Measured = std::pair<Mechanism::Direction, Mechanism::Direction>;
  const std::vector<Measured> angles{
      {BC, {}},         {{v}, {}},  {BC, {v}}, {{v}, BC},
      {{w}, {v}},       {{w}, {g}}, {DR, AB},  {{w}, AB},
      {AB, {w}},        {{v}, {x}}, {BC, BP},  // from the same start
      {line(P, C), BC},                        // to the same end
      {BC, AB},                                // from where the other ends
      {AB, BC},                                // to where the other starts
      {CB, DC},         {DC, CB},   {DR, DC},  {line(R, D), line(C, D)},
  };
  for (std::size_t i = 0; i < angles.size(); ++i)
    d.angle("angle" + std::to_string(i), angles[i].first, angles[i].second);
  d.distance("BD", B, D);
  d.distance("PA", P, A);
  d.along("forward", D, S, x);
  d.along("backward", S, D, x);
  d.component("Px", P, 0);
  d.component("Py", P, 1);
  const Mechanism mechanism = d.release_pinned();
  const Solved s(mechanism, turning, instants(2));
  expect_rigid_bodies(mechanism, s, 1e-10);
  for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
    const auto at = [&](int p) { return s.position(k, mechanism.points[p].name); };
    const auto direction = [&](const Mechanism::Direction& e) -> Vec {
      if (!e.is_given()) return {1, 0, 0};
      if (e.is_line()) return at(e.to) - at(e.from);
      return s.position(k, mechanism.vectors[e.vector].name);
    };
    expect_near(at(B), polar(1, 1 + s.time(k)), 1e-12, "B");
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const std::string name = "angle" + std::to_string(i);
      expect_same_angle(s.scalar(k, name),
                        turn(direction(angles[i].second), direction(angles[i].first)), 1e-10, name);
    }
    EXPECT_NEAR(s.scalar(k, "BD"), norm(at(D) - at(B)), 1e-11);
    EXPECT_NEAR(s.scalar(k, "PA"), norm(at(A) - at(P)), 1e-11);
    EXPECT_NEAR(at(S)[1], 0, 1e-12);
    EXPECT_NEAR(s.scalar(k, "forward"), at(S)[0] - 4, 1e-11);
    EXPECT_GT(s.scalar(k, "forward"), 0);
    EXPECT_NEAR(s.scalar(k, "backward"), 4 - at(S)[0], 1e-11);
    EXPECT_LT(s.scalar(k, "backward"), 0);
    EXPECT_NEAR(s.scalar(k, "Px"), at(P)[0], 1e-13);
    EXPECT_NEAR(s.scalar(k, "Py"), at(P)[1], 1e-13);
  }
}

/// Adds the angle of every line of every body from the x axis, both ways round, and from the
/// line before it.
std::vector<Mechanism::Coordinate> measure_all_angles(Mechanism& mechanism) {
  std::vector<Mechanism::Coordinate> added;
  const auto measure = [&](const Mechanism::Direction& of, const Mechanism::Direction& from) {
    Mechanism::Coordinate c;
    c.name = "measured" + std::to_string(added.size());
    c.type = CoordinateType::angle;
    c.of = of;
    c.from = from;
    added.push_back(c);
  };
  Mechanism::Direction before{};
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    const std::vector<int>& points = mechanism.bodies[b].points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Mechanism::Direction now = line(points[i - 1], points[i]);
      measure(now, {});
      measure(line(points[i], points[i - 1]), {});
      if (before.is_given()) measure(now, before);
      before = now;
    }
  }
  mechanism.coordinates.insert(mechanism.coordinates.end(), added.begin(), added.end());
  return added;
}

/// However often it is measured, and wherever the body turns: one equation for each angle more.
TEST(Coordinates, EveryPlanarBodyIsMeasuredAgainOverTheWholeMotion) {
  int mechanisms = 0;
  for (Scene scene : library_scenes()) {
    if (scene.mechanism.dimension != 2) continue;
    ++mechanisms;
    SCOPED_TRACE(scene.mechanism.name);
    const auto added = measure_all_angles(scene.mechanism);
    const Mechanism& mechanism = scene.mechanism;
    const Model m = make_model(scene);
    for (const Constraint& c : m.constraints)
      EXPECT_TRUE(c.left_out == 0 || kept_rows(c) == 0 || is_linear(c))
          << c.name << ": " << constraint_kind_name(c.kind);
    std::vector<double> times;
    for (int i = 0; i < scene.grid.instants; ++i) times.push_back(scene.grid.time(i));
    for (const char* id : {"global_automatic_eigen", "block_automatic_klu"}) {
      const Solved s(m, times, id, scene.tolerance);
      for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
        const auto direction = [&](const Mechanism::Direction& e, bool rate) -> Vec {
          if (!e.is_given()) return rate ? Vec{} : Vec{1, 0, 0};
          const std::string &from = mechanism.points[e.from].name,
                            &to = mechanism.points[e.to].name;
          return rate ? s.velocity(k, to) - s.velocity(k, from)
                      : s.position(k, to) - s.position(k, from);
        };
        const auto turning_rate = [&](const Mechanism::Direction& e) {
          const Vec now = direction(e, false);
          return cross(now, direction(e, true))[2] / dot(now, now);
        };
        for (const Mechanism::Coordinate& c : added) {
          expect_same_angle(s.scalar(k, c.name),
                            turn(direction(c.from, false), direction(c.of, false)), 1e-8, c.name);
          const double rate = turning_rate(c.of) - turning_rate(c.from);
          EXPECT_NEAR(s.velocity(k, c.name)[0], rate, 1e-7 * (1 + std::abs(rate))) << c.name;
        }
      }
    }
  }
  EXPECT_GE(mechanisms, 7);
}

TEST(Coordinates, SlideIsMeasuredAgainFromTheOtherEndAndFromAside) {
  // The slider's path is along x once and along y once: either component of the definition's
  // remainder would vanish in one of the two.
  for (const double tilt : {0.0, std::numbers::pi / 2, 0.7}) {
    Sketch d("slide", 2);
    const int A = d.ground_point("A", {0, 0, 0}), E = d.ground_point("E", polar(-3, tilt));
    const int x = d.ground_vector("x", polar(1, tilt));
    const int B = d.point("B", polar(1, tilt + 1));
    const double reach = std::cos(1) + std::sqrt(9 - std::sin(1) * std::sin(1));
    const int C = d.point("C", polar(reach, tilt));
    d.body("crank", {A, B});
    const int rod = d.body("rod", {B, C});
    d.joint(JointType::revolute_on_slider, Sketch::ground, rod, {A, C}, {x});
    d.angle("theta", line(A, B)).driven = true;
    d.along("s", A, C, x);
    d.along("further", E, C, x);
    d.along("back", C, A, x);
    const Solved s(d.release_pinned(), {Polynomial{{tilt + 1, 1}}}, instants(6.3));
    for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
      const double theta = 1 + s.time(k), sine = std::sin(theta);
      const double expected = std::cos(theta) + std::sqrt(9 - sine * sine);
      EXPECT_NEAR(s.scalar(k, "s"), expected, 1e-11);
      EXPECT_NEAR(s.scalar(k, "further"), expected + 3, 1e-11);
      EXPECT_NEAR(s.scalar(k, "back"), -expected, 1e-11);
    }
  }
}

/// A slider-crank whose slider is drawn beside the line through the crank's pivot, if only by a
/// millionth, stays there as it does without the coordinates.
TEST(Coordinates, DistanceAlongASlideLeavesItBesideTheLineAsItIsDrawn) {
  const double r = 0.5, rate = 6;
  for (const double off : {0.0, 1e-11, -9e-7, 9e-7, 0.1}) {
    Sketch d("eccentric slider-crank", 2);
    const int A = d.ground_point("A", {0, 0, 0}), x = d.ground_vector("x", {1, 0, 0});
    const int B = d.point("B", {r, 0, 0}), C = d.point("C", {2, off, 0});
    d.bodies({{"crank", {A, B}}, {"rod", {B, C}}});
    const int slider = d.body("slider", {C}, {x});
    d.joint(JointType::prismatic, Sketch::ground, slider, {A, C}, {x}, "slide");
    d.angle("theta", line(A, B)).driven = true;
    d.along("forward", A, C, x);
    d.along("backward", C, A, x);
    const Solved s(d.release_pinned(), {Polynomial{{0, rate}}}, instants(1));
    for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
      const double angle = rate * s.time(k), across = off - r * std::sin(angle);
      const double along = std::sqrt(1.5 * 1.5 + off * off - across * across),
                   c = r * std::cos(angle) + along,
                   c_rate = rate * r * (across * std::cos(angle) / along - std::sin(angle));
      expect_near(s.position(k, "C"), {c, off, 0}, 1e-12, "C");
      expect_near(s.velocity(k, "C"), {c_rate, 0, 0}, 1e-11, "velocity of C");
      EXPECT_NEAR(s.scalar(k, "forward"), c, 1e-12);
      EXPECT_NEAR(s.scalar(k, "backward"), -c, 1e-12);
    }
    EXPECT_FALSE(HasFailure()) << off;
  }
}

TEST(Coordinates, AnyOfThemCanDrive) {
  // The same four-bar in the same motion, driven by what another coordinate of it measured.
  const auto driven_by = [](const std::string& driver) {
    Sketch d = four_bar_sketch();
    d.distance("BD", 2, 1);
    d.angle("mu", line(2, 3), line(0, 2));     // B-C from A-B
    d.angle("gamma", line(3, 2), line(3, 1));  // C-B from C-D
    d.component("Cx", 3, 0);
    d.component("By", 2, 1);
    return driven(d.release_pinned(), {driver});
  };
  const double t = 0.2;
  const Solved expected(driven_by("theta"), turning, std::vector{t});
  for (const char* driver : {"psi", "BD", "mu", "gamma", "Cx", "By"}) {
    const double value = expected.scalar(0, driver);
    Solved actual(driven_by(driver), {Polynomial{{value}}}, std::vector{0.0});
    for (const char* name : {"B", "C"})
      expect_near(actual.position(0, name), expected.position(0, name), 1e-10,
                  name + std::string(" driven by ") + driver);
  }
}

}  // namespace
}  // namespace desmo::coordinates_test
