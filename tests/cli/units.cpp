// Units of what desmo writes and reads.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "tests/cli/program.h"

namespace desmo::units_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// The size in SI units of what a heading names: "d/dt C.x [mm/s]".
double unit_of_heading(const std::string& heading) {
  static const std::map<std::string, double> sizes{{"m", 1},       {"mm", 1e-3}, {"cm", 1e-2},
                                                   {"in", 0.0254}, {"rad", 1},   {"deg", degree},
                                                   {"s", 1},       {"-", 1},     {"1", 1}};
  const std::size_t begin = heading.rfind('[') + 1;
  return sizes.at(heading.substr(begin, heading.find_first_of("/]", begin) - begin));
}

/// Each number is rounded once on its way from SI units.
TEST_F(Cli, WritesInTheUnitsOfTheMechanismToOneRounding) {
  for (const char* name : {"slider_crank", "double_wishbone", "whitworth", "watt_six_bar"}) {
    const std::string solve = "solve " + std::string(name) + " --quiet";
    const std::vector<std::string> si = lines_of(solve + " --units si");
    const std::vector<std::string> shown = lines_of(solve);
    ASSERT_EQ(shown.size(), si.size());
    std::vector<double> units;
    for (const std::string& heading : cells(shown[0])) units.push_back(unit_of_heading(heading));
    EXPECT_TRUE(std::ranges::count(units, degree) > 0) << shown[0];
    for (const std::string& heading : cells(si[0])) EXPECT_EQ(unit_of_heading(heading), 1);
    for (std::size_t i = 1; i < si.size(); ++i) {
      const std::vector<double> from = numbers(si[i]), to = numbers(shown[i]);
      for (std::size_t k = 0; k < to.size(); ++k)
        ASSERT_EQ(to[k], from[k] / units[k]) << name << ", row " << i << ", " << shown[0];
    }
  }
}

TEST_F(Cli, SiUnitsChangeNothingWhereTheFileHasThem) {
  for (const char* name :
       {"andrews", "stewart", "jansen_leg", "four_bar:2", "truck_suspension:1"}) {
    const std::string expected = printed("solve " + std::string(name) + " --quiet --no-compile");
    EXPECT_TRUE(printed("solve " + std::string(name) + " --quiet --no-compile --units si") ==
                expected)
        << name;
  }
  expect_said(64, "solve andrews --units imperial",
              "--units: 'imperial' is none of its values; there are 'file', 'si'");
}

TEST_F(Cli, AScenesOwnUnitsComeBeforeTheMechanisms) {
  write("scene.json", replaced(slider_crank(150, R"(, "time": {"end": 1, "step": 0.25},
    "request": [{"points": ["B"]}, {"angles": ["theta"]}])"),
                               R"("units": {"angle": "deg"},
  "motion")",
                               R"("units": {"length": "in", "angle": "rad"},
  "motion")"));
  EXPECT_EQ(lines_of("solve scene.json --quiet")[0], "t [s],B.x [in],B.y [in],theta [rad]");
  // The crank of 50 mm turns by 90 rad.
  EXPECT_NEAR(numbers(lines()[2])[1], 50 / 25.4 * std::cos(90), 1e-9);
  EXPECT_NEAR(numbers(lines()[2])[3], 90, 1e-12);
  expect_said(0, "solve scene.json", "; relative to 1.97 in or 1 rad\n");
}

/// The phase is an angle where the driver is a length, too: sin(90°) = 1.
TEST_F(Cli, AHarmonicsPhaseIsInTheScenesUnitOfAngle) {
  const std::string scene = driven_slider(R"({"type": "harmonic", "mean": 150, "terms": [
      {"amplitude": 20, "frequency": 0.5, "phase": 90}]})"),
                    time = R"("time": {)", request = R"("request": [{"distances": ["s"]}], )";
  write("scene.json",
        replaced(replaced(scene, time, request + time), R"("version": 1)", R"("version": 2)"));
  ASSERT_EQ(lines_of("solve scene.json --quiet").size(), 4u);
  EXPECT_EQ(lines()[0], "t [s],s [mm]");
  for (const auto& [row, s] : {std::pair(1, 170.), {2, 150.}, {3, 130.}})
    EXPECT_NEAR(numbers(lines()[row])[1], s, 1e-12);
}

}  // namespace
}  // namespace desmo::units_test
