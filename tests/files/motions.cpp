// Motions as people describe them: from where the mechanism is drawn, by speeds and limits, against
// closed forms in quadruple precision.

#include <gtest/gtest.h>

#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "cases/mechanism/drawing.h"
#include "cases/mechanism/formatted.h"
#include "tests/files/common.h"

namespace desmo::motions_test {
namespace {

using Wide = boost::multiprecision::float128;

const Wide pi = acos(Wide(-1));
constexpr double exact = 1e-30;
constexpr double exact_angle = 1e-20;  // of the drawing: of sines in compensated arithmetic

/// The motion of the only driver of a scene.
Motion motion_of(const std::string& mechanism, const std::string& driver, const std::string& motion,
                 const std::string& time = time_of_one_second) {
  return parse_scene(
             scene_of(mechanism, "\"motion\": {\"" + driver + "\": " + motion + "}, " + time),
             "s.json", testing::TempDir())
      .motions[0];
}

void expect_motion(const Motion& motion, double t, const Wide& z, const Wide& v, const Wide& a,
                   double tolerance = exact) {
  const MotionSample<Wide> found = sample(motion, Wide(t));
  EXPECT_NEAR(double(found.position - z), 0, tolerance) << "t = " << t;
  EXPECT_NEAR(double(found.velocity - v), 0, tolerance) << "t = " << t;
  EXPECT_NEAR(double(found.acceleration - a), 0, tolerance) << "t = " << t;
  const MotionSample<double> rounded = sample(motion, t);
  EXPECT_NEAR(rounded.position, double(z), 4e-15) << "t = " << t;
  EXPECT_NEAR(rounded.velocity, double(v), 4e-15) << "t = " << t;
}

TEST(MotionFromTheDrawing, BeginsAtTheExactValueOfEveryKindOfCoordinate) {
  const Wide slope = atan2(Wide(1), Wide(3));
  const std::pair<const char*, Wide> values[] = {
      {"angle", atan2(Wide(4), Wide(3))},
      {"turn", atan2(Wide(4), Wide(-5)) - slope},
      {"distance", 5},
      {"diagonal", sqrt(Wide(41))},
      {"along", 24 / sqrt(Wide(10))},
      {"height", 6},
  };
  for (const auto& [name, value] : values) {
    SCOPED_TRACE(name);
    const std::string mechanism = drawn(name);
    const Wide unit = std::string(name) == "angle" || std::string(name) == "turn" ? pi / 180 : 1;
    const Motion line = motion_of(mechanism, name, R"({"type": "polynomial", "from": "drawing",
                                                       "coefficients": [1, 2]})");
    expect_motion(line, 0.75, value + unit * 2.5, 2 * unit, 0, exact_angle);
    const Motion still =
        motion_of(mechanism, name, R"({"type": "constant", "value": 0, "from": "drawing"})");
    expect_motion(still, 0.3, value, 0, 0, exact_angle);
    const Motion sum = motion_of(mechanism, name, R"({"type": "harmonic", "from": "drawing",
        "mean": 3, "terms": [{"amplitude": 2, "frequency": 0.5}]})");
    const Wide phase = pi / 4;
    expect_motion(sum, 0.25, value + unit * (3 + 2 * sin(phase)), 2 * unit * pi * cos(phase),
                  -2 * unit * pi * pi * sin(phase), exact_angle);
    const Motion table = motion_of(mechanism, name, R"({"type": "table", "from": "drawing",
        "times": [0, 1, 2], "values": [0, 7, 14]})");
    expect_motion(table, 1.5, value + unit * 10.5, unit * 7, 0, exact_angle);
    const Motion speed = motion_of(mechanism, name, R"({"type": "speed", "value": -4})");
    expect_motion(speed, 0.5, value - 2 * unit, -4 * unit, 0, exact_angle);
  }
}

TEST(MotionFromTheDrawing, IsMeasuredInSpaceToo) {
  const std::string opposite =
      replaced(spatial, "\"theta\": {\"angle\": [\"A\", \"B\"]", "\"theta\": {\"angle\": \"q\"");
  const std::string turned =
      replaced(replaced(opposite, "\"u\": [0, 0, 1],", "\"u\": [0, 0, 1], \"q\": [-2, 1, 7],"),
               "\"vectors\": [\"u\"]}", "\"vectors\": [\"u\", \"q\"]}");
  const Motion speed = motion_of(turned, "theta", R"({"type": "speed", "value": 0.5})");
  expect_motion(speed, 1, atan2(Wide(1), Wide(2)) + 0.5, 0.5, 0, exact_angle);
}

TEST(MotionFromTheDrawing, MayStartFromANumberInstead) {
  const Motion speed = motion_of(drawn("angle"), "angle",
                                 R"({"type": "speed", "from": 30, "value": 4, "acceleration": 3})");
  expect_motion(speed, 0.5, (30 + 2 + 1.5 / 4) * pi / 180, 5.5 * pi / 180, 3 * pi / 180);
}

TEST(Speed, HasAUnitOfItsOwn) {
  const std::tuple<const char*, const char*, Wide> units[] = {
      {"angle", "rpm", pi / 30},    {"angle", "deg/s", pi / 180}, {"angle", "rad/s", 1},
      {"distance", "m/s", 1},       {"distance", "mm/s", 1e-3},   {"distance", "cm/s", 1e-2},
      {"distance", "in/s", 0.0254},
  };
  for (const auto& [name, unit, size] : units) {
    SCOPED_TRACE(unit);
    const std::string members = std::string(R"({"type": "speed", "value": 10, "from": 0,
        "acceleration": 6, "unit": ")") +
                                unit + "\"}";
    expect_motion(motion_of(drawn(name), name, members), 0.5, size * 5.75, size * 13, size * 6);
  }
}

/// A trapezoid of 90° at up to 60°/s and 120°/s² begins at 0.25 s, is steady from 0.75 s to 1.75 s,
/// and rests at 2.25 s.
TEST(Trapezoid, IsAsFastAsItsLimitsAllow) {
  const std::string limits = R"("velocity": 60, "acceleration": 120, "start": 0.25, "from": 10})";
  const std::string time = R"("time": {"start": -9, "end": 9, "step": 1})";
  const Wide degree = pi / 180;
  for (const int way : {1, -1}) {
    const Motion m = motion_of(
        drawn("angle"), "angle",
        R"({"type": "trapezoid", "by": )" + std::to_string(90 * way) + ", " + limits, time);
    const auto expect = [&](double t, double z, double v, double a) {
      expect_motion(m, t, (10 + way * z) * degree, way * v * degree, way * a * degree);
    };
    expect(-9, 0, 0, 0);
    expect(0.2, 0, 0, 0);
    expect(0.5, 3.75, 30, 120);
    expect(0.6875, 11.484375, 52.5, 120);
    expect(1, 30, 60, 0);
    expect(1.5, 60, 60, 0);
    expect(2, 86.25, 30, -120);
    expect(2.5, 90, 0, 0);
    expect(9, 90, 0, 0);
  }
}

/// 30° at 120°/s² take 1 s; 60°/s would be reached in the middle.
TEST(Trapezoid, IsATriangleWhereItsVelocityIsNotReached) {
  for (const char* velocity : {"60", "100", "1e100"}) {
    const Motion m = motion_of(drawn("angle"), "angle",
                               std::string(R"({"type": "trapezoid", "by": 30, "from": 0,
                                   "acceleration": 120, "velocity": )") +
                                   velocity + "}");
    const Wide degree = pi / 180;
    expect_motion(m, 0.25, 3.75 * degree, 30 * degree, 120 * degree);
    expect_motion(m, 0.75, 26.25 * degree, 30 * degree, -120 * degree);
    expect_motion(m, 1.5, 30 * degree, 0, 0);
  }
}

/// From rest to rest at a time.
MotionSample<Wide> trapezoid(const Wide& s, const Wide& v, const Wide& a, const Wide& time) {
  const Wide up = v / a, left = up + s / v - time;
  if (time < 0) return {0, 0, 0};
  if (time < up) return {a * time * time / 2, a * time, a};
  if (left > up) return {v * (time - up / 2), v, 0};
  if (left > 0) return {s - a * left * left / 2, a * left, -a};
  return {s, 0, 0};
}

/// Its phases end at times that are no doubles. With v² = a s, exactly (in degrees) or but for
/// rounding, no double lies in a steady phase.
TEST(Trapezoid, IsItsClosedFormWhereverItsPhasesEnd) {
  const Wide degree = pi / 180;
  for (const auto& [s, v, a, pieces] : {std::tuple(360., 120., 40., 4u),
                                        {90., 30., 10., 4u},
                                        {0.9, 0.3, 0.1, 4u},
                                        {4.2, 0.7, 1.3, 5u}}) {
    const Motion m = motion_of(drawn("angle"), "angle",
                               formatted(R"({"type": "trapezoid", "from": 0, "start": 5.3,
        "by": %.17g, "velocity": %.17g, "acceleration": %.17g})",
                                         s, v, a));
    EXPECT_EQ(std::get<Spline>(m).pieces().size(), pieces) << v;
    for (const double t : {5., 5.6, 6.4, 8.2, 8.4, 11.2, 11.4, 11.6, 12.}) {
      const auto z = trapezoid(s * degree, v * degree, a * degree, Wide(t) - 5.3);
      expect_motion(m, t, z.position, z.velocity, z.acceleration);
    }
  }
}

/// 10⁹ s after the origin doubles are 10⁻⁷ s apart, in which the velocity changes by 0.1.
TEST(Trapezoid, IsOnTheRightPieceAtEveryDouble) {
  const Motion m = motion_of(drawn("height"), "height", R"({"type": "trapezoid", "from": 0,
      "by": 2e6, "velocity": 3e5, "acceleration": 1e6, "start": 1e9})");
  const std::vector<double> knots = std::get<Spline>(m).knots();
  ASSERT_EQ(knots.size(), 6u);
  for (std::size_t i = 1; i < 5; ++i)
    for (const double t : {std::nextafter(knots[i], 0), knots[i], std::nextafter(knots[i], 2e9)}) {
      const MotionSample<Wide> found = sample(m, Wide(t)), z = trapezoid(2e6, 3e5, 1e6, t - 1e9);
      EXPECT_NEAR(double(found.position - z.position), 0, 1e-15) << i;
      EXPECT_NEAR(double(found.velocity - z.velocity), 0, 1e-15) << i;
      EXPECT_EQ(double(found.acceleration), double(z.acceleration)) << i;
    }
}

TEST(SceneFile, MayHaveASingleInstant) {
  const std::string ask = "\"motion\": {\"theta\": {\"type\": \"speed\", \"value\": 1}}, ";
  const Scene s = parse_scene(scene_of(slider_crank, ask + R"("time": {"at": 0.25})"), "", "");
  EXPECT_EQ(s.grid.instants, 1);
  EXPECT_EQ(s.grid.time(0), 0.25);
  expect_start(scene_complaint(scene_of(slider_crank, ask + R"("time": {"at": 1, "step": 1})")),
               "s.json: /time/step: unknown key 'step'");
}

TEST(SceneFile, MotionsThatAreWrongAreNamed) {
  const std::pair<const char*, const char*> faults[] = {
      {R"("type": "speed", "value": 1, "from": "start")",
       "/from: unknown start 'start'; there are 'drawing'"},
      {R"("type": "speed", "value": 1, "unit": "mm/s")",
       "/unit: unknown unit 'mm/s'; there are 'rpm', 'rad/s', 'deg/s'"},
      {R"("type": "speed")", ": the key 'value' is missing"},
      {R"("type": "trapezoid", "by": 0, "velocity": 1, "acceleration": 1)", "/by: is 0, no motion"},
      {R"("type": "trapezoid", "by": 1, "velocity": 0, "acceleration": 1)",
       "/velocity: is a limit, and not above 0"},
      {R"("type": "trapezoid", "by": 1, "velocity": 1, "acceleration": -1)",
       "/acceleration: is a limit, and not above 0"},
      {R"("type": "trapezoid", "by": 1, "velocity": 1, "acceleration": 1, "start": 1e50)",
       ": the times at which it changes cannot be told apart; change its limits"},
      {R"("type": "table", "file": "t.csv", "times": [0, 1])", ": has a file, and lists as well"},
  };
  for (const auto& [motion, message] : faults) {
    const std::string scene =
        scene_of(slider_crank,
                 "\"motion\": {\"theta\": {" + std::string(motion) + "}}, " + time_of_one_second);
    expect_start(scene_complaint(scene), "s.json: /motion/theta" + std::string(message));
  }
}

TEST(Drawing, MeasuresAngles) {
  for (const auto& [y, x] : {std::pair{0., -1.}, {-1e-9, -1.}, {1e-200, 1e-200}, {-3., 0.}}) {
    const Derived angle = atan2(Derived(y), Derived(x));
    EXPECT_EQ(angle.value, std::atan2(y, x));
    EXPECT_LT(angle.radius, exact_angle);
    const Wide off = abs(as<Wide>(angle) - atan2(Wide(y), Wide(x)));
    EXPECT_LE(double(off), angle.radius + 1e-33);
  }
}

}  // namespace
}  // namespace desmo::motions_test
