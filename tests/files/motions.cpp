// Motions as people describe them: from where the mechanism is drawn, by speeds, limits and tables,
// against closed forms in quadruple precision.

#include <gtest/gtest.h>

#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "cases/mechanism/drawing.h"
#include "tests/files/common.h"
#include "tests/started.h"

namespace desmo::motions_test {
namespace {

using Wide = boost::multiprecision::float128;

const Wide pi = acos(Wide(-1));
constexpr double exact = 1e-30;
constexpr double exact_angle = 1e-20;  // of the drawing: of sines in compensated arithmetic

/// A crank of 3 and 4 and a slider, with coordinates of all kinds; `driver` is driven.
std::string drawn(const std::string& driver) {
  return R"({"format": "desmo-mechanism", "version": 1, "name": "drawn", "dimension": 2,
    "units": {"angle": "deg"},
    "points": {"A": [1, 2], "B": [4, 6], "C": [9, 2]}, "vectors": {"u": [3, 1]},
    "ground": {"points": ["A"], "vectors": ["u"]},
    "bodies": {"crank": {"points": ["A", "B"]}, "rod": {"points": ["B", "C"]}},
    "joints": [{"type": "revolute", "bodies": ["ground", "crank"], "points": ["A"]},
               {"type": "revolute", "bodies": ["crank", "rod"], "points": ["B"]}],
    "coordinates": {"angle": {"angle": ["A", "B"], "estimate": 370},
                    "turn": {"angle": ["C", "B"], "from": "u"},
                    "distance": {"distance": ["A", "B"]}, "diagonal": {"distance": ["B", "C"]},
                    "along": {"distance": ["A", "C"], "along": "u"},
                    "height": {"component": "B", "axis": "y"}},
    "drivers": [")" +
         driver + "\"]}";
}

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

/// Where times are no doubles, pieces still meet to far more digits.
TEST(Trapezoid, IsContinuous) {
  const Motion m = motion_of(drawn("height"), "height", R"({"type": "trapezoid", "by": 7,
      "velocity": 0.7, "acceleration": 1.3, "start": 0.1})");
  const Spline& s = std::get<Spline>(m);
  ASSERT_EQ(s.pieces().size(), 5u);
  for (std::size_t i = 1; i < 5; ++i) {
    const auto at_end =
        sample_polynomial(s.pieces()[i - 1], Wide(Wide(s.knots()[i]) - s.knots()[i - 1]));
    const auto at_begin = sample_polynomial(s.pieces()[i], Wide(0));
    EXPECT_NEAR(double(at_end.position - at_begin.position), 0, exact) << i;
    EXPECT_NEAR(double(at_end.velocity - at_begin.velocity), 0, 1.3 * 0x1p-53 * s.knots()[i]) << i;
  }
}

class TableFile : public InFolder {
 protected:
  /// Reads the scene with a table of these rows, or says why not.
  std::string read(const std::string& rows, Scene* scene = nullptr) {
    write("t.csv", rows);
    return refusal<InputError>([&] {
      const Scene s = parse_scene(text_, "s.json", folder_);
      if (scene) *scene = s;
    });
  }

  /// The angle moves by a table in a file.
  std::string text_ =
      scene_of(drawn("angle"), R"("motion": {"angle": {"type": "table", "file": "t.csv"}},
                                  "time": {"end": 2, "step": 1})");
};

TEST_F(TableFile, HasRowsOfTimesAndValues) {
  const double degree = std::acos(-1.0) / 180;
  for (const char* rows :
       {"0,0\n1,10\n2,40\n", "0 0\r\n\r\n1\t10\r\n2 40", "time,deflection\n0,0\n1,10\n2,40\n",
        "angle [deg],flag,t [s]\n0,,0\n10,,1\n40,,2\n", "\"t\",\"angle\"\n0,0\n1,+1e1\n2,40\n",
        "\xEF\xBB\xBF"
        "0,0\n1,10\n2,40\n",
        "\xEF\xBB\xBF"
        "angle,flag,t\n0,,0\n10,,1\n40,,2\n"}) {
    Scene scene;
    ASSERT_EQ(read(rows, &scene), "accepted") << rows;
    EXPECT_EQ(sample(scene.motions[0], 1.0).position, 10 * degree) << rows;
    EXPECT_NEAR(sample(scene.motions[0], 2.0).position, 40 * degree, 1e-15) << rows;
  }
  for (const char* heading : {"t [s],angle [rad]", "Time (s),Motor (rad)"}) {
    Scene scene;
    ASSERT_EQ(read(heading + std::string("\n0,0\n1,10\n2,40\n"), &scene), "accepted");
    EXPECT_EQ(sample(scene.motions[0], 1.0).position, 10) << heading;
  }
}

TEST_F(TableFile, WhatIsWrongIsNamedWithItsLine) {
  const std::pair<const char*, const char*> faults[] = {
      {"", "has 0 rows; a table needs 2 or more"},
      {"t,angle\n0,0\n", "has 1 rows"},
      {"0,0,0\n1,1,1\n", "line 1: has 3 columns and no heading; give two, 't' and 'angle'"},
      {"t,angel,s\n0,0,0\n", "line 1: no column is called 'angle'; did you mean 'angel'?"},
      {"angle,t2\n0,0\n1,1\n", "line 1: column 1 is called 'angle', where 't' is expected"},
      {"x,t\n0,0\n1,1\n", "line 1: column 2 is called 't', where 'angle' is expected"},
      {"t,turn [rad]\n0,0\n1,1\n", "line 1: column 2 is called 'turn', where 'angle' is expected"},
      {"t [ms],angle\n0,0\n1,1\n",
       "line 1: 't' is in 'ms', no unit that it can have; give it in 's'"},
      {"t,z (mm)\n0,0\n1,1\n",
       "line 1: 'angle' is in 'mm', no unit that it can have; give it in 'deg'"},
      {"t,angle\n0,0\n\n1,x\n", "line 4: column 2: 'x' is not a number"},
      {"0,0\n1,nan\n", "line 2: column 2: 'nan' is not a number"},
      {"0,0\n1,1e101\n", "line 2: column 2: '1e101' is not a number up to 1e100"},
      {"0,0\n1\n", "line 2: has 1 columns, where 2 are expected"},
      {"0,0\n1,1\n1,2\n", "line 3: its 't' is not above the one before"},
  };
  const std::string start = "s.json: /motion/angle/file: the table file '" + file("t.csv") + "': ";
  for (const auto& [rows, message] : faults) expect_start(read(rows), start + message);
  expect_start(read("0,0\n1,1\n"),
               "s.json: /time: the table of 'angle' reaches only from 0 s to 1 s");
}

/// The height follows the angle by a table in a file.
class CouplingFile : public TableFile {
 protected:
  CouplingFile() {
    text_ = scene_of(replaced(drawn("turn"), "\"drivers\"",
                              R"("couplings": {"c": {"coordinate": "height", "of": "angle",
                                                    "file": "t.csv"}}, "drivers")"),
                     R"("motion": {"turn": {"type": "constant", "value": 0}}, "time": {"at": 0})");
  }
};

/// Numbers stay those of the file, whose units count exactly.
TEST_F(CouplingFile, HasRowsOfArgumentsAndValues) {
  const Wide degree = pi / 180;
  const std::tuple<const char*, Wide, Wide> files[] = {
      {"-30,5\n60,7\n110,6.5\n", degree, 1},
      {"a,h\r\n\r\n-30,5\r\n60,7\r\n110,6.5", degree, 1},
      {"height [mm],flag,angle [deg]\n5,,-30\n7,,60\n6.5,,110\n", degree, 1e-3},
      {"angle [rad]\theight [in]\n-30\t5\n60\t7\n110\t6.5\n", 1, 0.0254},
  };
  for (const auto& [rows, of_arguments, of_values] : files) {
    Scene scene;
    ASSERT_EQ(read(rows, &scene), "accepted") << rows;
    const Mechanism::Coupling& c = scene.mechanism.couplings[0];
    EXPECT_EQ(c.table->arguments, (std::vector<double>{-30, 60, 110})) << rows;
    EXPECT_EQ(c.table->values, (std::vector<double>{5, 7, 6.5})) << rows;
    EXPECT_NEAR(double(as<Wide>(c.terms[0].factor) * of_values - 1), 0, exact) << rows;
    EXPECT_NEAR(double(as<Wide>(c.terms[1].factor) * of_arguments - 1), 0, exact) << rows;
  }
}

TEST_F(CouplingFile, WhatIsWrongIsNamedWithItsLine) {
  const std::pair<const char*, const char*> faults[] = {
      {"angle,height\n0,0\n", "has 1 rows; a table needs 2 or more"},
      {"0,0,0\n1,1,1\n", "line 1: has 3 columns and no heading; give two, 'angle' and 'height'"},
      {"t,height,s\n0,0,0\n", "line 1: no column is called 'angle'; there are 't', 'height', 's'"},
      {"height,a\n0,0\n1,1\n", "line 1: column 1 is called 'height', where 'angle' is expected"},
      {"angle [mm],height\n0,0\n1,1\n", "line 1: 'angle' is in 'mm', no unit that it can have"},
      {"angle,height [1]\n0,0\n1,1\n",
       "line 1: 'height' is in '1', no unit that it can have; give it in 'm'"},
      {"0,0\nnan,1\n", "line 2: column 1: 'nan' is not a number"},
      {"0,0\n1,1\n1,1\n", "line 3: its 'angle' is not above the one before; give ascending ones"},
      {"0,0\n2,1\n1,1\n", "line 3: its 'angle' is not above the one before; give ascending ones"},
  };
  const std::string start = "s.json: /mechanism/couplings/c/file: the table file '" + file("t.csv");
  for (const auto& [rows, message] : faults) expect_start(read(rows), start + "': " + message);
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
      {R"("type": "table", "file": "")", "/file: '' is no file name; give that of a table file"},
      {R"("type": "table", "file": "none.csv")", "/file: the table file '"},
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
