// Measures that a scene requests of bodies, joints and rates, against closed forms, and against
// differences of positions of a quadruple reference.

#include "tests/modelling/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/modelling/differences.h"

namespace desmo::measures_test {
namespace {

TEST(Measures, OfASliderCrankHaveClosedForms) {
  const Scene s = scene(slider_crank, turning, R"(
      {"rotations": ["crank", "rod"], "joints": ["*"], "level": "acceleration"},
      {"points": {"CG": {"body": "rod", "at": [90, 10]}}, "level": "velocity"},
      {"angles": {"mu": {"angle": ["CG", "B"], "from": ["CG", "C"]},
                  "rod angle": {"angle": ["B", "C"], "from": "x"}}, "level": "velocity"},
      {"distances": {"gap": {"distance": ["A", "CG"]}}},
      {"ratios": {"ratio": ["C.x", "theta"]}})");
  const std::vector<double> times = instants(1.5);
  const Rows rows(s, times);
  const double r = 0.05, l = 0.15;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double t = times[i];
    SCOPED_TRACE(t);
    const double theta = 2 * pi * t + pi / 2 * t * t, speed = 2 * pi + pi * t, rate = pi;
    // l sin phi = -r sin theta
    const double sine = -r * std::sin(theta) / l, phi = std::asin(sine), cosine = std::cos(phi);
    const double phi_d = -r * std::cos(theta) * speed / l / cosine;
    const double phi_dd = (r / l * (std::sin(theta) * speed * speed - std::cos(theta) * rate) +
                           sine * phi_d * phi_d) /
                          cosine;
    expect_same_angle(rows(i, "crank.rotation"), theta, 1e-12, "crank");
    EXPECT_GT(rows(i, "crank.rotation"), -pi);
    EXPECT_LE(rows(i, "crank.rotation"), pi);
    EXPECT_NEAR(rows(i, "crank.omega"), speed, 1e-11);
    EXPECT_NEAR(rows(i, "crank.alpha"), rate, 1e-10);
    EXPECT_NEAR(rows(i, "rod.rotation"), phi, 1e-13);
    EXPECT_NEAR(rows(i, "rod.omega"), phi_d, 1e-11);
    EXPECT_NEAR(rows(i, "rod.alpha"), phi_dd, 1e-10);
    expect_same_angle(rows(i, "revolute/crank/rod.angle"), phi - theta, 1e-12, "joint");
    EXPECT_NEAR(rows(i, "d/dt revolute/crank/rod.angle"), phi_d - speed, 1e-11);
    EXPECT_NEAR(rows(i, "d2/dt2 revolute/crank/rod.angle"), phi_dd - rate, 1e-10);
    const double x = r * std::cos(theta) + l * cosine;
    const double x_d = -r * std::sin(theta) * speed - l * sine * phi_d;
    EXPECT_NEAR(rows(i, "prismatic/ground/slider.travel"), x - r - l, 1e-14);
    EXPECT_NEAR(rows(i, "d/dt prismatic/ground/slider.travel"), x_d, 1e-12);
    EXPECT_NEAR(rows(i, "ratio"), x_d / speed, 1e-12);
    // In the rod's frame CG is at (40, 10) mm from B.
    const double cg_x = r * std::cos(theta) + 0.04 * cosine - 0.01 * sine,
                 cg_y = r * std::sin(theta) + 0.04 * sine + 0.01 * cosine;
    EXPECT_NEAR(rows(i, "CG.x"), cg_x, 1e-13);
    EXPECT_NEAR(rows(i, "CG.y", Level::velocity),
                r * std::cos(theta) * speed + (0.04 * cosine - 0.01 * sine) * phi_d, 1e-12);
    EXPECT_NEAR(rows(i, "gap"), std::hypot(cg_x, cg_y), 1e-13);
    expect_same_angle(rows(i, "mu"), std::atan2(-0.01, -0.04) - std::atan2(-0.01, 0.11), 1e-12, "");
    EXPECT_NEAR(rows(i, "rod angle", Level::velocity), phi_d, 1e-11);
  }
}

/// Returns v, turned by a rotation vector.
Vec turned(const Vec& v, const Vec& rotation) {
  return turned_about(unit(rotation), norm(rotation), v);
}

TEST(Measures, OfAWishboneCornerAreDifferencesOfItsPositions) {
  const Scene s = scene(R"({"library": "double_wishbone"})", R"(
      "steering": {"type": "polynomial", "coefficients": [380, 20]},
      "height": {"type": "harmonic", "mean": 330, "terms": [{"amplitude": 70, "frequency": 1}]})",
                        R"(
      {"rotations": ["upright"], "joints": ["prismatic/ground/rack", "revolute/ground/lower"],
       "level": "acceleration"},
      {"points": ["*"], "vectors": ["a"], "level": "velocity"},
      {"angles": {"my camber": {"angle": "a", "from": "y", "towards": "z"},
                  "my toe": {"angle": "a", "from": "y", "towards": "x"}}, "level": "velocity"},
      {"ratios": {"motion ratio": ["damper", "W.z"]}})");
  const std::vector<double> times{0.03, 0.1, 0.2, 0.35, 0.6, 0.9};
  const Rows rows(s, times);
  const Model& m = rows.plan().model;
  for (std::size_t i = 0; i < times.size(); ++i) {
    SCOPED_TRACE(times[i]);
    const Differences exact(m, times[i]);
    const Vec rotation = rows.vector(i, "upright.rotation"),
              omega = rows.vector(i, "upright.omega"), alpha = rows.vector(i, "upright.alpha");
    const auto position = [&](const char* name) {
      return s.mechanism
          .points[std::ranges::find(s.mechanism.points, name, &Mechanism::Point::name) -
                  s.mechanism.points.begin()]
          .position;
    };
    for (const auto& [p, q] : {std::pair("LB", "UB"), {"TO", "W"}, {"N", "LB"}}) {
      const Vec line = rows.vector(i, q) - rows.vector(i, p);
      expect_near(line, turned(position(q) - position(p), rotation), 1e-13, q);
      expect_near(cross(omega, line), exact.vector(q, 1) - exact.vector(p, 1), 1e-11, q);
      expect_near(cross(alpha, line) + cross(omega, cross(omega, line)),
                  exact.vector(q, 2) - exact.vector(p, 2), 1e-9, q);
    }
    const Vec a = rows.vector(i, "a");
    EXPECT_NEAR(rows(i, "my camber"), std::atan2(a[2], a[1]), 1e-13);
    EXPECT_NEAR(rows(i, "my toe"), std::atan2(a[0], a[1]), 1e-13);
    EXPECT_NEAR(rows(i, "my toe", Level::velocity), exact("my toe", 1), 1e-11);
    EXPECT_NEAR(rows(i, "motion ratio"), exact("damper", 1) / exact("W.z", 1), 1e-10);
    EXPECT_NEAR(rows(i, "prismatic/ground/rack.travel"), 0.02 * times[i], 1e-14);
    // The lower wishbone turns LB about lw by its joint's angle, the same as the drawing's.
    const Vec axis = unit({1, 0.02, -0.03});
    const double rate = rows(i, "d/dt revolute/ground/lower.angle");
    expect_near(rate * cross(axis, rows.vector(i, "LB") - position("LO")), exact.vector("LB", 1),
                1e-11, "LB");
    expect_near(
        turned(position("LB") - position("LO"), rows(i, "revolute/ground/lower.angle") * axis),
        rows.vector(i, "LB") - position("LO"), 1e-13, "LB");
  }
}

/// A drum that turns and slides on a post, and a flap on it that a hinge holds.
const std::string drum = R"({"format": "desmo-mechanism", "version": 1, "name": "drum",
  "dimension": 3, "units": {"angle": "deg"},
  "points": {"O": [0, 0, 0], "P": [0, 0, 0.3], "H": [0.2, 0, 0.3], "K": [0.2, 0.4, 0.3],
             "F": [0.5, 0.1, 0.3]},
  "vectors": {"x": [1, 0, 0], "y": [0, 1, 0], "z": [0, 0, 1], "u": [1, 0, 0], "v": [0, 1, 0]},
  "ground": {"points": ["O"], "vectors": ["x", "y", "z"]},
  "bodies": {"drum": {"points": ["P", "H", "K"], "vectors": ["z", "u"]},
             "flap": {"points": ["H", "K", "F"]}},
  "joints": [
    {"name": "post", "type": "cylindrical", "bodies": ["ground", "drum"], "vectors": ["z"],
     "points": ["O", "P"]},
    {"name": "hinge", "type": "hinge", "bodies": ["drum", "flap"], "points": ["H", "K"]}],
  "coordinates": {"turn": {"angle": "u", "from": "x", "towards": "y"},
                  "lift": {"distance": ["O", "P"], "along": "z"},
                  "open": {"angle": ["H", "F"], "from": "u", "towards": "z"}},
  "drivers": ["turn", "lift", "open"]})";

TEST(Measures, OfJointsInSpaceFollowTheirDrivers) {
  const Scene s =
      scene(drum, R"("turn": {"type": "polynomial", "coefficients": [0, 200, 10]},
      "lift": {"type": "polynomial", "coefficients": [0.3, 0.1, 0.2]},
      "open": {"type": "polynomial", "coefficients": [0, -50, 20]})",
            R"({"joints": ["post", "hinge"], "rotations": ["flap"], "level": "acceleration"})");
  const std::vector<double> times = instants(1.2, 0.05);
  const Rows rows(s, times);
  const double degree = pi / 180;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double t = times[i];
    SCOPED_TRACE(t);
    const double turn = (200 * t + 10 * t * t) * degree, open = (-50 * t + 20 * t * t) * degree;
    const double turn_d = (200 + 20 * t) * degree, open_d = (-50 + 40 * t) * degree;
    expect_same_angle(rows(i, "post.angle"), turn, 1e-12, "post");
    EXPECT_NEAR(rows(i, "d/dt post.angle"), turn_d, 1e-12);
    EXPECT_NEAR(rows(i, "post.travel"), 0.1 * t + 0.2 * t * t, 1e-14);
    EXPECT_NEAR(rows(i, "d2/dt2 post.travel"), 0.4, 1e-12);
    // About HK, which is y, a turn from x towards z is negative.
    EXPECT_NEAR(rows(i, "hinge.angle"), -open, 1e-12);
    EXPECT_NEAR(rows(i, "d/dt hinge.angle"), -open_d, 1e-12);
    EXPECT_NEAR(rows(i, "d2/dt2 hinge.angle"), -40 * degree, 1e-11);
    const Vec axis{-std::sin(turn), std::cos(turn), 0};
    const Vec axis_d = turn_d * Vec{-std::cos(turn), -std::sin(turn), 0};
    const Vec along{0, 0, 1};
    expect_near(rows.vector(i, "flap.omega"), turn_d * along + -open_d * axis, 1e-12, "omega");
    expect_near(rows.vector(i, "flap.alpha"),
                20 * degree * along + -40 * degree * axis + -open_d * axis_d, 1e-11, "alpha");
  }
}

/// A crank and a lever on it, both in frames of their own that are roughly placed. Their rotations
/// are the frames'; turns of their joints begin at that place.
TEST(Measures, OfBodiesWithFramesTurnWithThese) {
  for (const int rough : {-30, -12}) {
    const Scene s = scene(R"({"format": "desmo-mechanism", "version": 1, "name": "boom",
      "dimension": 2, "units": {"angle": "deg"}, "points": {"O": [0, 0]},
      "ground": {"points": ["O"]},
      "bodies": {"boom": {"at": [0.01, 0, 40], "points": {"O": [0, 0], "B": [2, 0]}},
                 "stick": {"at": [1.5, 1.2, )" +
                              std::to_string(rough) + R"(], "points": {"B": [0, 0], "E": [1, 0]}}},
      "joints": [
        {"name": "J1", "type": "revolute", "bodies": ["ground", "boom"], "points": ["O"]},
        {"name": "J2", "type": "revolute", "bodies": ["boom", "stick"], "points": ["B"]}],
      "coordinates": {"a": {"angle": ["O", "B"]}, "b": {"angle": ["B", "E"]}},
      "drivers": ["a", "b"]})",
                          R"("a": {"type": "polynomial", "coefficients": [40, 50]},
      "b": {"type": "polynomial", "coefficients": [-30, -20]})",
                          R"({"points": {"CG": {"body": "stick", "at": [0.4, 0.1]}}},
      {"rotations": ["stick"], "joints": ["J2"], "level": "velocity"})");
    const std::vector<double> times = instants(1, 0.1);
    const Rows rows(s, times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double t = times[i] * pi / 180, a = 2 * pi / 9 + 50 * t, b = -pi / 6 - 20 * t;
      EXPECT_NEAR(rows(i, "stick.rotation"), b, 1e-13);
      EXPECT_NEAR(rows(i, "J2.angle"), b - a - (rough - 40) * pi / 180, 1e-13);
      EXPECT_NEAR(rows(i, "d/dt J2.angle"), -70 * pi / 180, 1e-13);
      EXPECT_NEAR(rows(i, "CG.x"), 2 * std::cos(a) + 0.4 * std::cos(b) - 0.1 * std::sin(b), 1e-13);
    }
  }
}

/// A lid, turned about the z of its frame on a post that leans by 0.3 about x.
TEST(Measures, OfABodyWithAFrameInSpaceIsTheFramesRotation) {
  for (const char* rough : {"0, 0, 0", "0.2, 0.05, -0.1"}) {
    const Scene s = scene(R"({"format": "desmo-mechanism", "version": 1, "name": "lid",
      "dimension": 3, "points": {"O": [0, 0, 0]},
      "vectors": {"x": [1, 0, 0], "z": [0, -0.2955202066613396, 0.955336489125606],
                  "y": {"normal": ["z", "x"]}},
      "ground": {"points": ["O"], "vectors": ["x", "y", "z"]},
      "bodies": {"lid": {"at": [0, 0, 0, )" +
                              std::string(rough) + R"(],
        "points": {"O": [0, 0, 0], "E": [1, 0, 0]}, "vectors": {"z": [0, 0, 1]}}},
      "joints": [{"type": "revolute", "bodies": ["ground", "lid"], "points": ["O"],
                  "vectors": ["z"]}],
      "coordinates": {"a": {"angle": ["O", "E"], "from": "x", "towards": "y"}},
      "drivers": ["a"]})",
                          R"("a": {"type": "polynomial", "coefficients": [0.2, 1]})",
                          R"({"rotations": ["lid"]})");
    const std::vector<double> times = instants(1, 0.25);
    const Rows rows(s, times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double a = 0.2 + times[i], sine = std::sin(0.3), cosine = std::cos(0.3);
      const Vec rotation = rows.vector(i, "lid.rotation");
      expect_near(turned({1, 0, 0}, rotation),
                  {std::cos(a), cosine * std::sin(a), sine * std::sin(a)}, 1e-13, "x");
      expect_near(turned({0, 0, 1}, rotation), {0, -sine, cosine}, 1e-13, "z");
    }
  }
}

}  // namespace
}  // namespace desmo::measures_test
