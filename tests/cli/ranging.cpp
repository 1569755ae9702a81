// desmo range.

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/program.h"
#include "tests/flaps.h"

namespace desmo::ranging_test {
namespace {

TEST_F(Cli, SaysHowFarACrankGoesAndWhatStopsIt) {
  write("scene.json", locks);  // in mm and degrees
  expect_printed("range scene.json", "short, from t = 0 s", "theta, from 0 deg",
                 "  up    36.86989764584", " deg: locks, known within ", "  down  -36.86989764584",
                 "group   SG-II (rod, slider)", "moves   C",
                 "joints  revolute/rod/slider, prismatic/ground/slider", "loop    crank, rod");
  const Json driver = json_of("range - --units si --json <scene.json")["drivers"][0];
  EXPECT_EQ(driver["name"], "theta");
  EXPECT_EQ(driver["unit"], "rad");
  EXPECT_EQ(driver["idle"], false);
  ASSERT_EQ(driver["ends"].size(), 2u);
  const Json up = driver["ends"][1];
  EXPECT_EQ(up["stop"], "dead_point");
  EXPECT_NEAR(up["value"].get<double>(), std::asin(0.6), 1e-13);
  EXPECT_GT(up["beyond"], up["value"]);
  EXPECT_NEAR(up["beyond"].get<double>(), std::asin(0.6), 1e-12);
  EXPECT_EQ(up["groups"], Json({"SG-II"}));
  const Json in_degrees = json_of("range scene.json --json")["drivers"][0];
  EXPECT_EQ(in_degrees["unit"], "deg");
  for (const char* key : {"value", "beyond"})
    EXPECT_NEAR(in_degrees["ends"][1][key].get<double>(), std::asin(0.6) * 180 / std::numbers::pi,
                1e-10);
}

/// Far from zero doubles are sparse, and the text must not be more certain than they are.
TEST_F(Cli, RangesAreKnownAsWellAsTheTextSays) {
  const double locks_at = std::asin(0.6) * 180 / std::numbers::pi;
  for (const char* turns : {"0", "-360", "-360000", "-36000000", "360000000"}) {
    write("far.json", replaced(locks, "[0, 360]", std::string("[") + turns + "]"));
    const double start = std::stod(turns);
    printed("range far.json");
    int ends = 0;
    for (const std::string& line : lines()) {
      char direction[5];
      double value, uncertainty;
      if (std::sscanf(line.c_str(), " %4s %lf deg: locks, known within %lf deg", direction, &value,
                      &uncertainty) != 3)
        continue;
      ++ends;
      const bool is_up = std::string(direction) == "up";
      const double distance = std::abs(value - start - (is_up ? locks_at : -locks_at));
      EXPECT_LE(distance, uncertainty) << line;
      EXPECT_LE(uncertainty, 1e-12 + 2e-15 * std::abs(value)) << line;
    }
    EXPECT_EQ(ends, 2) << out_;
    const Json driver = json_of("range far.json --json")["drivers"][0];
    EXPECT_LT(driver["ends"][0]["beyond"], driver["ends"][0]["value"]) << turns;
    EXPECT_GT(driver["ends"][1]["beyond"], driver["ends"][1]["value"]) << turns;
  }
}

/// In double precision the angle in the sine would be rounded to 1e-7 rad, or 6e-8 rad.
TEST_F(Cli, RangesStartAtTheMotionToTheLastDigit) {
  const std::pair<const char*, const char*> late[] = {
      {R"({"frequency": 1, "amplitude": 1, "phase": 1000000000})", "0.25"},
      {R"({"frequency": 1000, "amplitude": 1})", "100000.1234"}};
  for (const auto& [term, time] : late) {
    write("late.json",
          replaced(replaced(slider_crank(150, std::string(R"(, "time": {"at": )") + time +
                                                  R"(}, "request": [{"angles": ["theta"]}])"),
                            R"({"angle": "deg"})", R"({"angle": "rad"})"),
                   R"({"type": "polynomial", "coefficients": [0, 360]})",
                   std::string(R"({"type": "harmonic", "terms": [)") + term + "]}"));
    const double start = json_of("range late.json --json")["drivers"][0]["start"];
    EXPECT_EQ(start, numbers(lines_of("solve late.json")[1])[1]) << term;
  }
}

TEST_F(Cli, SaysOfEveryDriverWhereItStops) {
  const Json drivers = json_of("range stewart --json")["drivers"];
  ASSERT_EQ(drivers.size(), 6u);
  for (const Json& d : drivers) {
    EXPECT_EQ(d["unit"], "m");
    EXPECT_LT(d["ends"][0]["value"], d["start"]);
    EXPECT_GT(d["ends"][1]["value"], d["start"]);
  }
  expect_printed("range slider_crank", "up    360 deg: turns fully");
}

/// Crank and rod are as long, and in line at the start: a dead point of the slider.
TEST_F(Cli, ADistanceEndsAtZeroWhereASignedOneGoesOn) {
  for (const bool is_signed : {false, true}) {
    const char* const s =
        is_signed ? R"({"distance": ["A", "C"], "along": "x"})" : R"({"distance": ["A", "C"]})";
    write("scene.json", driven_by_s(slider_crank(50, R"(, "time": {"end": 1, "step": 0.01})"), s,
                                    "m", R"({"type": "polynomial", "coefficients": [0.1]})"));
    const Json driver = json_of("range scene.json --json")["drivers"][0];
    ASSERT_EQ(driver["ends"].size(), 3u) << "the other branch from the dead point";
    EXPECT_EQ(driver["ends"][1]["stop"], "dead_point");
    EXPECT_NEAR(driver["ends"][1]["value"].get<double>(), 0.1, 1e-14);
    for (const int down : {0, 2}) {
      const Json end = driver["ends"][down];
      EXPECT_EQ(end["direction"], "down");
      EXPECT_EQ(end["stop"], is_signed ? "dead_point" : "zero_length");
      EXPECT_NEAR(end["value"].get<double>(), is_signed ? -0.1 : 0, 1e-14);
    }
    EXPECT_EQ(driver["change_points"].size(), is_signed ? 2u : 0u);  // one on each branch
  }
}

/// The boom is hardly longer than the ground, and the driver much shorter. So the tangents of the
/// branches that cross next to zero hardly differ.
TEST_F(Cli, ADistanceThatIsDrawnShortGoesNotBelowZero) {
  write("scene.json", R"({"format": "desmo-scene", "version": 2, "time": {"at": 0},
    "motion": {"l": {"type": "constant", "from": "drawing", "value": 0}},
    "mechanism": {"format": "desmo-mechanism", "version": 1, "name": "boom", "dimension": 2,
      "points": {"O": [0, 0], "A": [1, 0], "B": [0.99955, 0.0299966]},
      "ground": {"points": ["O", "A"]},
      "bodies": {"boom": {"points": ["O", "B"], "length": 1.00000001}},
      "joints": [{"type": "revolute", "bodies": ["ground", "boom"], "points": ["O"]}],
      "coordinates": {"l": {"distance": ["A", "B"]}}, "drivers": ["l"]}})");
  const Json end = json_of("range scene.json --json")["drivers"][0]["ends"][0];
  EXPECT_EQ(end["stop"], "zero_length");
  EXPECT_NEAR(end["value"].get<double>(), 0, 1e-7);
}

/// The note says nothing of positions beyond the start.
TEST_F(Cli, RangesSayWhichEquationsDoNotHoldAtTheStart) {
  write("flap.json", flaps(1, 4e-7));
  desmo("range flap.json");
  EXPECT_TRUE(says("the equations contradict each other: 'flap1: H-K length' is off by 4.0e-07 m"))
      << err_;
}

TEST_F(Cli, RangesNeedAStart) {
  write("scene.json", replaced(locks, "[0, 360]", "[90, 1]"));
  expect_said(1, "range scene.json",
              "scene.json: no position was found at the start of driver 'theta'", "SG-II");
  EXPECT_TRUE(out_.empty());
  EXPECT_EQ(desmo("range"), 64);
  EXPECT_EQ(desmo("range nothing"), 66);
}

}  // namespace
}  // namespace desmo::ranging_test
