// desmo solve: the numbers.

#include "tests/cli/program.h"

namespace desmo::solving_test {
namespace {

TEST_F(Cli, SolvesWhatIsFixed) {
  for (const char* level : {"position", "velocity", "acceleration"}) {
    write("fixed.json", R"({"format": "desmo-scene", "version": 2,
      "mechanism": {"library": "slider_crank"},
      "motion": {"theta": {"type": "constant", "value": 20}}, "time": {"end": 1, "step": 0.5},
      "request": [{"points": ["A"], "level": ")" +
                            std::string(level) + R"("}]})");
    write("rows", "0 0 1 0\n0.5 0 1 0\n1 0 1 0\n");
    for (const char* how : {"", " --strict", " --past-failures", " --check mechanism --strict",
                            " --drivers rows --strict", " --formulation global_automatic_klu",
                            " --formulation group_symbolic_explicit/lanes:4"}) {
      ASSERT_EQ(desmo("solve fixed.json" + std::string(how)), 0) << level << how << err_;
      ASSERT_EQ(lines().size(), 4u);
      EXPECT_TRUE(lines()[2].starts_with("0.5,0,0")) << lines()[2];
    }
  }
}

TEST_F(Cli, EveryFormulationGivesTheSameAnswer) {
  const Json formulations = json_of("list formulations --json")["formulations"];
  const std::string scene = slider_crank(150, R"(, "time": {"end": 0.2, "step": 0.1},
    "request": [{"points": ["C"], "level": "acceleration"}], "tolerance": 1e-13)");
  write("scene.json", scene);
  std::vector<double> expected;
  for (const Json& f : formulations) {
    ASSERT_EQ(desmo("solve scene.json --units si --formulation " + f["id"].get<std::string>()), 0)
        << err_;
    const std::vector<double> last = numbers(lines().back());
    if (expected.empty()) expected = last;
    ASSERT_EQ(last.size(), expected.size());
    for (std::size_t i = 0; i < last.size(); ++i) EXPECT_NEAR(last[i], expected[i], 1e-9) << f;
  }
}

TEST_F(Cli, TakesSettingsAsSuffixesOfTheFormulation) {
  const std::string id = "group_automatic_klu/guess:hermite5/jacobian:step/tolerance:1e-9";
  expect_printed("solve slider_crank --format jsonl --formulation " + id,
                 id);  // it stands in the heading
  expect_said(64, "solve slider_crank --formulation group_automatic_klu/guess:cubic",
              "unknown value 'cubic' of '/guess:'; there are: previous, linear");
  expect_said(64, "solve slider_crank --formulation group_automatic_klu/lanes:4",
              "there is code for four lanes or eight, in explicit order");
}

/// The generator's scene by name, and in a scene file that says no tolerance, are one.
TEST_F(Cli, SolvesAGeneratorToOneToleranceHoweverItIsNamed) {
  const std::pair<const char*, const char*> generators[] = {{"four_bar", "dyads"},
                                                            {"truck_suspension", "axles"}};
  for (const auto& [name, unit] : generators) {
    write("generated.json",
          R"({"format": "desmo-scene", "version": 2, "mechanism": {"generator": ")" +
              std::string(name) + "\", \"" + unit + "\": 1}}");
    const std::string with = " --quiet --formulation group_automatic_klu";
    const std::string from_file = printed("solve generated.json" + with);
    EXPECT_TRUE(printed("solve " + std::string(name) + ":1" + with) == from_file) << name;
    EXPECT_TRUE(printed("solve " + std::string(name) + ":1" + with + "/tolerance:1e-12") ==
                from_file)
        << name;
  }
}

TEST_F(Cli, ExplainsWhatIsNotSolved) {
  write("scene.json", R"({"format": "desmo-scene", "version": 1,
    "mechanism": {"generator": "truck_suspension", "axles": 2}, "time": {"end": 0.1, "step": 0.1},
    "request": [{"points": ["axle1/S"], "level": "velocity"}]})");
  expect_said(0, "solve scene.json --explain", " of 221 unknowns, 2 of 4 drivers", "to velocity",
              "serves axle1/S", "groups not needed: axle1/SG-II",
              "dropped: ", "drivers not needed: axle2/zL, axle2/zR");
  EXPECT_EQ(lines().size(), 3u);
  expect_said(0, "solve slider_crank --explain --quiet", "solved: 8 of 8 unknowns, 1 of 1 driver");
}

TEST_F(Cli, SaysThatADistanceIsDrawnAtZero) {
  write("zero.json", measured_distance("[200, 0]"));
  expect_said(1, "solve zero.json --no-compile",
              "constraint 'd: definition', t = 0 s: the drawing is singular: a distance is "
              "measured whose points coincide there",
              "; draw the points apart, or measure something else");
  write("apart.json", measured_distance("[200, 9]"));
  EXPECT_EQ(desmo("solve apart.json --no-compile"), 0) << err_;
}

TEST_F(Cli, ReadsScenesFromStandardInput) {
  write("scene.json", slider_crank(150, R"(, "time": {"end": 1, "step": 0.1})"));
  const std::string expected = printed("solve scene.json --quiet");
  EXPECT_EQ(printed("solve - --quiet <scene.json"), expected);
  EXPECT_EQ(printed("solve - --quiet -o - <scene.json"), expected);
}

}  // namespace
}  // namespace desmo::solving_test
