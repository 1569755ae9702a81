// desmo solve: what it says of how right its numbers are.

#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/program.h"
#include "tests/wheel.h"

namespace desmo::accuracy_test {
namespace {

/// Returns a crank of 50 that turns by a polynomial of time [rad], in steps of 1 s. It starts
/// at 1.2 rad; a rod of 49 cannot follow from 1.37 rad to 1.77 rad.
std::string turns_by(const std::string& coefficients, int end) {
  const std::string scene =
      slider_crank(49, R"(, "time": {"end": )" + std::to_string(end) + R"(, "step": 1})");
  return replaced(replaced(scene, "[0, 360]", "[" + coefficients + "]"),
                  R"("units": {"angle": "deg"},
  "motion")",
                  R"("units": {"angle": "rad"}, "motion")");
}

/// From rest to rest at 1.94 rad, where no motion leads, in one step.
const std::string goes_between = turns_by("1.2, 0, 0, 7.4, -11.1, 4.44", 1);
/// There, and back to where it locks.
const std::string fails_then = turns_by("1.2, 1.2946, -0.5546", 2);

constexpr const char* flagged_in_between =
    "accuracy: degraded: 1 row of 2, the first at group 'SG-II' (rod, slider), t = ";

TEST_F(Cli, SaysHowRightTheNumbersAre) {
  expect_said(0, "solve slider_crank -o out/motion.csv",
              "accuracy: 401 of 401 rows proven; condition 6.2e+00, errors at most ",
              " in acceleration; relative to 200 mm or 57.3 deg, ");
  EXPECT_FALSE(says("degraded")) << err_;

  write("scene.json", slider_crank(150, R"(, "time": {"end": 1, "step": 0.1},
    "request": [{"points": ["C"]}])"));
  expect_said(0, "solve scene.json", "accuracy: 11 of 11 rows proven; condition ");
  EXPECT_FALSE(says("velocity")) << err_;
  ASSERT_EQ(desmo("solve scene.json --strict --quiet"), 0) << err_;
  EXPECT_EQ(err_, "");
}

TEST_F(Cli, SaysOfARunThatFailsWhatWasFlaggedBefore) {
  write("fails.json", fails_then);
  for (const char* to : {"", " -o out/motion.csv"}) {
    expect_said(1, "solve fails.json" + std::string(to), flagged_in_between,
                "t = 2 s: no position was found");
  }
  expect_said(1, "solve fails.json --quiet", flagged_in_between);  // flags are never hidden
}

TEST_F(Cli, DeliversWhatIsFlaggedUnlessItIsStrict) {
  write("between.json", goes_between);
  EXPECT_EQ(lines_of("solve between.json").size(), 3u);
  EXPECT_TRUE(says("the motion cannot be followed past a singular position")) << err_;
  expect_said(1, "solve between.json --strict -o out/motion.csv",
              "desmo: between.json: group 'SG-II' (rod, slider), t = ", " s to 1 s: ",
              "; choose a motion that avoids it, or solve without --strict");
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "out"));
  write("steps.json",
        std::regex_replace(goes_between, std::regex("\"step\": 1"), "\"step\": 0.125"));
  EXPECT_EQ(desmo("solve steps.json -o motion.csv"), 1);
}

TEST_F(Cli, ChecksAsMuchAsIsAskedFor) {
  const std::string all = "rows proven; condition ", sampled = "rows on a proven branch, one in ";
  for (const auto& [mode, what] : std::map<std::string, std::string>{
           {"proof", all},
           {"proof --formulation block_symbolic_inlined/stride:16", all},
           {"mechanism", all},
           {"sample:1", all},
           {"sample", sampled + "16 to"},
           {"sample:4", sampled + "4 to"}}) {
    expect_said(0, "solve slider_crank --strict -o out/motion.csv --check " + mode,
                "accuracy: 401 of 401 " + what);
  }
  expect_said(0, "solve slider_crank --check none -o out/motion.csv",
              "note: nothing is proven (--check none)");
  EXPECT_FALSE(says("accuracy")) << err_;
  for (const char* mode : {"prof", "sample:0", "sample:x", "proof:2", ""})
    EXPECT_EQ(desmo("solve slider_crank --check '" + std::string(mode) + "'"), 64) << mode;
  EXPECT_EQ(desmo("solve slider_crank --check sample --drivers rows.csv"), 64);
}

/// A group that is not asked for may lock, though not a crank that is turned. A note says so, and
/// the whole mechanism is checked on demand.
TEST_F(Cli, NamesTheGroupsThatAreNotChecked) {
  write("scene.json", slider_crank(49, R"(, "time": {"end": 0.5, "step": 0.1},
    "request": [{"angles": ["theta"]}])"));
  expect_said(0, "solve scene.json",
              "note: not checked: group 'SG-II' (rod, slider), which the request does not need; ");
  expect_said(1, "solve scene.json --check mechanism --strict", "group 'SG-II' (rod, slider)");
}

/// A four-bar of stated lengths, drawn roughly. In 40 digits C(1) is (1.408005679416214059625…,
/// 0.508280406620575479142…) for the lengths of the file; for their rounded squares 1.6e-14 off.
TEST_F(Cli, DeliversTheMotionOfTheFileWhereItIsProven) {
  const std::string scene = DESMO_SOURCE_DIR "/tests/checked/scenes/proof_stated_lengths.json";
  for (const char* id : {"block_symbolic_inlined", "global_automatic_klu/tolerance:1e-6"}) {
    EXPECT_EQ(lines_of("solve " + scene + " --formulation " + id).back(),
              "1,1.4080056794162141,0.5082804066205755")
        << id;
    EXPECT_TRUE(says("accuracy: 2 of 2 rows proven; ")) << err_ << id;  // near a dead point
  }
}

/// With a stride, rows between two solved instants are not lost, and no gap ends before it begins.
TEST_F(Cli, GoesOnPastWhatCannotBeAssembled) {
  write("locks.json", locks);
  for (const char* how : {" --formulation group_automatic_lapack/stride:4", ""}) {
    // It locks when 50 sin θ is 30.
    expect_said(0, "solve locks.json --past-failures -o out/motion.csv" + std::string(how),
                "t = 0.10241638", " s to 0.39758361", "t = 0.60241638", " s to 0.89758361");
    out_ = text_of(out("motion.csv"));
    EXPECT_EQ(lines().size(), 1u + 11 + 21 + 11);
  }
  for (const char* text : {"accuracy: not assembled: group 'SG-II' (rod, slider), t = 0.10241638",
                           "no position was found; at best '", "' is off by ", " mm\n"})
    EXPECT_TRUE(says(text)) << text << "\n" << err_;
  EXPECT_EQ(desmo("solve locks.json --past-failures --strict"), 64);
  expect_said(64, "solve locks.json --past-failures --check none",
              "--past-failures with --check none: only a run that is checked goes on ");
}

TEST_F(Cli, FailsWhereNoRowCanBeAssembled) {
  const std::vector<double> at{0, 20, 40, 60, 80, 100, 120}, rise{0, 5, 15, 20, 15, 5, 0};
  const Wheel beyond{.couplings = coupling_table("rise", at, rise), .driver = "w", .start = 30};
  for (const std::string& scene : {replaced(locks, "[0, 360]", "[90]"), beyond.text()}) {
    write("never.json", scene);
    ASSERT_EQ(desmo("solve never.json --no-compile --quiet"), 1);
    const std::string failure = err_;
    expect_said(1, "solve never.json --no-compile --quiet --past-failures", failure,
                "accuracy: not assembled: group 'SG-II' (", "), t = 0 s to 1 s, the end: ");
    EXPECT_EQ(lines().size(), 1u);
  }
  EXPECT_EQ(desmo("solve never.json --past-failures -o out/motion.csv"), 1);
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "out"));
}

/// Runs each command of the page, after "    $ desmo", and expects the lines below it without "…".
TEST_F(Cli, DoesWhatThePageOnStabilityShows) {
  write("between.json", goes_between);
  std::istringstream page(text_of(DESMO_SOURCE_DIR "/formulations/stability.md"));
  const std::string indent = "    ", command = indent + "$ desmo ", rest = "…";
  int commands = 0, lines = 0;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with(command)) {
      ++commands;
      ASSERT_EQ(desmo(line.substr(command.size())), 0) << line << '\n' << err_;
    } else if (line.starts_with(indent) && commands > 0) {
      ++lines;
      EXPECT_TRUE(says(line.substr(indent.size(), line.find(rest) - indent.size()))) << line << '\n'
                                                                                     << err_;
    }
  }
  EXPECT_EQ(commands, 2);
  EXPECT_EQ(lines, 3);
}

TEST_F(Cli, ProvesNumbersAtLateTimes) {
  write("late.json", R"({"format": "desmo-scene", "version": 1,
    "mechanism": {"library": "slider_crank"},
    "time": {"start": 67108864, "end": 67108865, "step": 0.125}})");
  expect_said(0, "solve late.json", "accuracy: 9 of 9 rows proven; ");
  EXPECT_TRUE(says("errors at most 2.8e-08")) << "half a digit of the angle: " << err_;
}

}  // namespace
}  // namespace desmo::accuracy_test
