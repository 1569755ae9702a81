// What desmo solve flags, in every form of output, however quiet.

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/program.h"

namespace desmo::flags_test {
namespace {

using Json = nlohmann::json;

/// A parallelogram that turns from 100° to 260°; branches meet at 180°, which no instant hits.
const std::string parallelogram = R"({"format": "desmo-scene", "version": 2, "mechanism": {
    "format": "desmo-mechanism", "version": 1, "name": "parallelogram", "dimension": 2,
    "units": {"angle": "deg"},
    "points": {"A": [0, 0], "B": [0, 1], "C": [2, 1], "D": [2, 0]},
    "ground": {"points": ["A", "D"]},
    "bodies": {"crank": {"points": ["A", "B"]}, "rod": {"points": ["B", "C"]},
               "rocker": {"points": ["C", "D"]}},
    "joints": [
      {"type": "revolute", "bodies": ["ground", "crank"], "points": ["A"]},
      {"type": "revolute", "bodies": ["crank", "rod"], "points": ["B"]},
      {"type": "revolute", "bodies": ["rod", "rocker"], "points": ["C"]},
      {"type": "revolute", "bodies": ["rocker", "ground"], "points": ["D"]}],
    "coordinates": {"theta": {"angle": ["A", "B"]}}, "drivers": ["theta"]},
  "motion": {"theta": {"type": "polynomial", "coefficients": [100, 160]}},
  "time": {"end": 1, "step": 0.04},
  "request": [{"points": ["C"], "level": "acceleration"}]})";

TEST_F(Cli, QuietRunsSayWhatIsFlagged) {
  write("scene.json", parallelogram);
  ASSERT_EQ(desmo("solve scene.json --quiet"), 0) << err_;
  EXPECT_TRUE(err_.starts_with("accuracy: degraded: group ")) << err_;
  EXPECT_TRUE(says("t = 0.48 s to 0.52 s: it passes a singular position")) << err_;
  EXPECT_FALSE(says("condition")) << err_;
  std::string rows;
  for (int i = 0; i <= 25; ++i)
    rows += std::to_string(0.04 * i) + " " + std::to_string(100 + 6.4 * i) + " 160 0\n";
  write("rows", rows);
  ASSERT_EQ(desmo("solve scene.json --quiet --drivers rows"), 0) << err_;
  EXPECT_TRUE(err_.starts_with("accuracy: degraded: group ")) << err_;
  write("locks.json", locks);
  ASSERT_EQ(desmo("solve locks.json --quiet --past-failures"), 0) << err_;
  EXPECT_TRUE(err_.starts_with("accuracy: not assembled: ")) << err_;
}

TEST_F(Cli, RowsCarryTheirFlags) {
  write("scene.json", parallelogram);
  ASSERT_EQ(desmo("solve scene.json --quiet"), 0) << err_;
  EXPECT_TRUE(lines()[0].starts_with("t [s],C.x [m],C.y [m],")) << lines()[0];
  const std::vector<std::string> plain = lines();
  ASSERT_EQ(desmo("solve scene.json --quiet --columns flag"), 0) << err_;
  const std::vector<std::string> csv = lines();
  ASSERT_EQ(csv.size(), 27u);
  EXPECT_EQ(csv[0], plain[0] + ",flag");
  ASSERT_EQ(desmo("solve scene.json --quiet --format jsonl"), 0) << err_;
  const std::vector<std::string> jsonl = lines();
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

/// The crank of the second instant lacks 6e-11 rad to where it locks, at asin(30/50).
TEST_F(Cli, DegradedRowsSaySo) {
  write("nearly.json", slider_crank(30, R"(,
    "time": {"end": 0.10241638234, "step": 0.10241638234})"));
  ASSERT_EQ(desmo("solve nearly.json --quiet --columns flag"), 0) << err_;
  ASSERT_EQ(lines().size(), 3u);
  EXPECT_TRUE(lines()[1].ends_with(",")) << lines()[1];
  EXPECT_TRUE(lines()[2].ends_with(",degraded")) << lines()[2];
  EXPECT_TRUE(err_.starts_with("accuracy: degraded: 1 instant of 2, ")) << err_;
}

}  // namespace
}  // namespace desmo::flags_test
