// Flags of desmo solve, in every form of output, however quiet.

#include <regex>

#include "tests/cli/program.h"
#include "tests/flaps.h"
#include "tests/parallelogram.h"

namespace desmo::flags_test {
namespace {

TEST_F(Cli, QuietRunsSayWhatIsFlagged) {
  write("scene.json", parallelogram_scene);
  ASSERT_EQ(desmo("solve scene.json --quiet"), 0) << err_;
  EXPECT_TRUE(err_.starts_with("accuracy: degraded: 1 row of 26, the first at group ")) << err_;
  EXPECT_TRUE(says(" s: it passes a singular position, where branches meet")) << err_;
  EXPECT_FALSE(says("condition")) << err_;
  std::string rows;
  for (int i = 0; i <= 25; ++i)
    rows += std::to_string(0.04 * i) + " " + std::to_string(100 + 6.4 * i) + " 160 0\n";
  write("rows", rows);
  expect_said(1, "solve scene.json --quiet --drivers rows",
              "line 14: group 'SG-II' (rod, rocker), ");
  write("locks.json", locks);
  ASSERT_EQ(desmo("solve locks.json --quiet --past-failures"), 0) << err_;
  EXPECT_TRUE(err_.starts_with("accuracy: not assembled: ")) << err_;
}

TEST_F(Cli, RowsCarryTheirFlags) {
  write("scene.json", parallelogram_scene);
  ASSERT_EQ(desmo("solve scene.json --quiet"), 0) << err_;
  EXPECT_TRUE(lines()[0].starts_with("t [s],C.x [m],C.y [m],")) << lines()[0];
  const std::vector<std::string> plain = lines();
  const std::vector<std::string> csv = lines_of("solve scene.json --quiet --columns flag");
  ASSERT_EQ(csv.size(), 27u);
  EXPECT_EQ(csv[0], plain[0] + ",flag");
  const std::vector<std::string> jsonl = lines_of("solve scene.json --quiet --format jsonl");
  ASSERT_EQ(jsonl.size(), csv.size());
  EXPECT_EQ(Json::parse(jsonl[0])["columns"].back(), (Json{{"name", "flag"}, {"unit", "-"}}));
  constexpr std::size_t after = 1 + 13;  // the first row beyond 180°, at t = 0.52 s
  for (std::size_t i = 1; i < csv.size(); ++i) {
    EXPECT_EQ(csv[i], plain[i] + (i == after ? ",crossing" : ",")) << i;
    EXPECT_EQ(Json::parse(jsonl[i]).back(), i == after ? Json("crossing") : Json()) << i;
  }
  EXPECT_EQ(desmo("solve scene.json --columns theta"), 64);
  EXPECT_EQ(desmo("solve scene.json --columns flag --drivers rows"), 64);
}

/// A row on the change point has a position and no rates.
TEST_F(Cli, RowsOnAChangePointHaveNoRates) {
  write("scene.json", std::regex_replace(parallelogram_scene, std::regex("0.04"), "0.125"));
  ASSERT_EQ(lines_of("solve scene.json --quiet --columns flag").size(), 10u);
  EXPECT_TRUE(std::regex_match(lines()[5], std::regex("0\\.5,[-.0-9e]+,[-.0-9e]+,,,,,crossing")))
      << lines()[5];
  ASSERT_EQ(desmo("solve scene.json --quiet --format jsonl"), 0) << err_;
  const Json row = Json::parse(lines()[5]);
  EXPECT_NEAR(row[1].get<double>(), 1, 1e-6);
  EXPECT_TRUE(row[3].is_null());
}

/// A body's own shape is longer than its hinge on the ground: by digits, or by more.
TEST_F(Cli, ShapesThatFitTheGroundButForDigitsAreFlagged) {
  const std::string flap = flaps(1, 4e-7), end = R"("time": {)";
  const std::string one_point = replaced(flap, end, R"("request": [{"points": ["F1"]}], )" + end);
  for (const std::string& scene : {flap, one_point}) {
    write("flap.json", scene);
    for (const std::string check : {"proof", "mechanism", "sample:4"}) {
      const std::string solve = "solve flap.json -o out/motion.csv --check " + check;
      expect_said(0, solve, "largest contradiction: 'flap1: H-K length' is off by 4.0e-07 m");
      expect_said(1, solve + " --strict", "the equations contradict each other");
    }
  }
  write("flap.json", flaps(1, 1e-4));
  expect_said(65, "solve flap.json", "'flap1: H-K length' is off by 0.0001 m");
}

}  // namespace
}  // namespace desmo::flags_test
