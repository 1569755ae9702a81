// desmo solve: what it says of how right its numbers are.

#include <regex>
#include <sstream>

#include "tests/cli/program.h"

namespace desmo::accuracy_test {
namespace {

/// The first of its two instants is as any; the crank of the second lacks 6e-11 rad to where it
/// locks, at asin(30/50).
const std::string nearly_locks = slider_crank(30, R"(,
  "time": {"end": 0.10241638234, "step": 0.10241638234})");

TEST_F(Cli, SaysHowRightTheNumbersAre) {
  ASSERT_EQ(desmo("solve slider_crank -o out/motion.csv"), 0) << err_;
  for (const char* text : {"accuracy: condition 1.8e+01, errors up to ",
                           " in acceleration; relative to 200 mm or 57.3 deg, "})
    EXPECT_TRUE(says(text)) << err_;
  EXPECT_FALSE(says("degraded")) << err_;

  write("scene.json", slider_crank(150, R"(, "time": {"end": 1, "step": 0.1},
    "request": [{"points": ["C"]}])"));
  ASSERT_EQ(desmo("solve scene.json"), 0) << err_;
  EXPECT_TRUE(says("accuracy: condition ")) << err_;
  EXPECT_FALSE(says("velocity")) << err_;
  ASSERT_EQ(desmo("solve scene.json --strict --quiet"), 0) << err_;
  EXPECT_EQ(err_, "");
}

TEST_F(Cli, DeliversDegradedInstantsAndSaysSo) {
  write("nearly.json", nearly_locks);
  ASSERT_EQ(desmo("solve nearly.json"), 0) << err_;
  EXPECT_EQ(lines().size(), 3u);
  EXPECT_TRUE(
      says("accuracy: degraded: 1 instant of 2, the first at group 'SG-II' (rod, slider), "
           "t = 0.102416382 s: so near a singular position that condition "))
      << err_;
}

TEST_F(Cli, SaysOfARunThatFailsWhatWasDegradedBefore) {
  // As in nearly_locks, and one step more.
  write("fails.json", slider_crank(30, R"(,
    "time": {"end": 0.20483276468, "step": 0.10241638234})"));
  for (const char* to : {"", " -o out/motion.csv"}) {
    EXPECT_EQ(desmo("solve fails.json" + std::string(to)), 1);
    EXPECT_TRUE(
        says("accuracy: degraded: 1 instant of 2, the first at group 'SG-II' (rod, slider), "
             "t = 0.102416382 s: so near a singular position that condition "))
        << err_;
    EXPECT_TRUE(says("t = 0.204832765 s: no position was found")) << err_;
  }
  EXPECT_EQ(desmo("solve fails.json --quiet"), 1);
  EXPECT_TRUE(says("accuracy: degraded: 1 instant of 2")) << "flags are never hidden";
}

TEST_F(Cli, StrictRefusesWhatIsDegraded) {
  write("nearly.json", nearly_locks);
  EXPECT_EQ(desmo("solve nearly.json --strict -o out/motion.csv"), 1);
  for (const char* text :
       {"desmo: nearly.json: group 'SG-II' (rod, slider), t = 0.102416382 s: so near a singular "
        "position that condition ",
        " in velocity, ", "; choose a motion that avoids it, or solve without --strict"})
    EXPECT_TRUE(says(text)) << err_;
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "out"));
}

TEST_F(Cli, ProvesBoundsWhereAsked) {
  ASSERT_EQ(desmo("solve slider_crank --certify --strict -o out/motion.csv"), 0) << err_;
  EXPECT_TRUE(says("proof: 401 of 401 instants; errors at most ")) << err_;
  EXPECT_TRUE(says(" in acceleration\n")) << err_;
  ASSERT_EQ(desmo("solve slider_crank -o out/other.csv"), 0) << err_;
  EXPECT_FALSE(says("proof")) << err_;
  EXPECT_EQ(desmo("solve slider_crank --certify --drivers rows.csv"), 64);
}

/// A four-bar of stated lengths, drawn roughly. In 40 digits C(1) is (1.408005679416214059625…,
/// 0.508280406620575479142…) for the lengths of the file; for their rounded squares 1.6e-14 off.
TEST_F(Cli, DeliversTheMotionOfTheFileWhereItIsProven) {
  write("stated.json", R"({"format": "desmo-scene", "version": 2, "name": "stated",
    "mechanism": {"format": "desmo-mechanism", "version": 1, "name": "four_bar", "dimension": 2,
      "points": {"A": [0, 0], "D": [2.55, 0], "B": [-0.1181668946184996, 1.475275087912834],
                 "C": [1.9918802124357762, 1.118482142338118]},
      "ground": {"points": ["A", "D"]},
      "bodies": {"C1": {"points": ["A", "B"], "length": 1.48},
                 "L2": {"points": ["B", "C"], "length": 2.14},
                 "L3": {"points": ["D", "C"], "length": 1.25}},
      "joints": [{"type": "revolute", "bodies": ["ground", "C1"], "points": ["A"]},
                 {"type": "revolute", "bodies": ["C1", "L2"], "points": ["B"]},
                 {"type": "revolute", "bodies": ["ground", "L3"], "points": ["D"]},
                 {"type": "revolute", "bodies": ["L2", "L3"], "points": ["C"]}],
      "coordinates": {"th": {"angle": ["A", "B"]}}, "drivers": ["th"]},
    "motion": {"th": {"type": "polynomial",
                      "coefficients": [1.6507238977497682, 0.2999984103208746]}},
    "time": {"start": 0, "end": 1, "step": 1}, "request": [{"points": ["C"], "level": "position"}]})");
  for (const char* id : {"block_symbolic_inlined", "global_automatic_klu/tolerance:1e-6"}) {
    ASSERT_EQ(desmo("solve stated.json --certify --formulation " + std::string(id)), 0) << err_;
    EXPECT_EQ(lines().back(), "1,1.4080056794162141,0.5082804066205755") << id;
    EXPECT_TRUE(says("proof: 2 of 2 instants; errors at most ")) << err_;
    EXPECT_TRUE(says("path: 1 of 1 steps stay on one branch")) << err_ << id;  // near a dead point
  }
}

TEST_F(Cli, GoesOnPastWhatCannotBeAssembled) {
  write("locks.json", locks);
  ASSERT_EQ(desmo("solve locks.json --past-failures -o out/motion.csv"), 0) << err_;
  out_ = text_of(out("motion.csv"));
  EXPECT_EQ(lines().size(), 1u + 11 + 21 + 11);
  // It locks when 50 sin θ is 30.
  for (const char* text :
       {"accuracy: not assembled: group 'SG-II' (rod, slider), t = 0.10241638", " s to 0.39758361",
        "t = 0.60241638", " s to 0.89758361", "no position was found; at the nearest to it '",
        "' is off by ", " mm\n"})
    EXPECT_TRUE(says(text)) << text << "\n" << err_;
  EXPECT_EQ(desmo("solve locks.json --past-failures --strict"), 64);
}

/// What lies between two solved instants is not lost with a stride, nor does a gap end before it
/// begins.
TEST_F(Cli, SaysOfAStrideWhatItSaysOfSteps) {
  write("locks.json", locks);
  const std::string solve = "solve locks.json --past-failures -o out/motion.csv --formulation ";
  ASSERT_EQ(desmo(solve + "group_automatic_lapack/stride:4"), 0) << err_;
  out_ = text_of(out("motion.csv"));
  EXPECT_EQ(lines().size(), 1u + 11 + 21 + 11);
  for (const char* text :
       {"t = 0.10241638", " s to 0.39758361", "t = 0.60241638", " s to 0.89758361"})
    EXPECT_TRUE(says(text)) << text << "\n" << err_;
}

TEST_F(Cli, SaysThatAStrideWasHalved) {
  const std::string solve = "solve slider_crank -o out/motion.csv --formulation ";
  ASSERT_EQ(desmo(solve + "block_symbolic_inlined/stride:16"), 0) << err_;
  EXPECT_TRUE(
      says("note: in places a stride of 16 is too long for the tolerance; it was halved, "
           "down to 1\n"))
      << err_;
  ASSERT_EQ(desmo(solve + "block_symbolic_inlined"), 0) << err_;
  EXPECT_FALSE(says("stride")) << err_;
}

/// A crank of 50 that goes from rest at 1.2 rad to rest at 1.94 rad, where a rod of 49 cannot
/// follow, in one step.
const std::string goes_between = [] {
  std::string scene = slider_crank(49, R"(, "time": {"end": 1, "step": 1})");
  const std::string turn = R"("units": {"angle": "deg"},
  "motion": {"theta": {"type": "polynomial", "coefficients": [0, 360]}})";
  return scene.replace(scene.find(turn), turn.size(),
                       R"("units": {"angle": "rad"}, "motion": {"theta": {
    "type": "polynomial", "coefficients": [1.2, 0, 0, 7.4, -11.1, 4.44]}})");
}();

/// What follows "    $ desmo" on the page is run; the lines after it are said, "…" left out.
TEST_F(Cli, DoesWhatThePageOnStabilityShows) {
  write("nearly.json", nearly_locks);
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
  EXPECT_EQ(commands, 3);
  EXPECT_EQ(lines, 7);
  EXPECT_EQ(desmo("solve between.json --certify --strict"), 1);
  EXPECT_TRUE(says("the step to t = 1 s: beyond t = ")) << err_;
  write("steps.json",
        std::regex_replace(goes_between, std::regex("\"step\": 1"), "\"step\": 0.125"));
  EXPECT_EQ(desmo("solve steps.json -o motion.csv"), 1);
}

TEST_F(Cli, BlamesRoundedDriversAtLateTimes) {
  write("late.json", R"({"format": "desmo-scene", "version": 1,
    "mechanism": {"library": "slider_crank"},
    "time": {"start": 67108864, "end": 67108865, "step": 0.125}})");
  ASSERT_EQ(desmo("solve late.json"), 0) << err_;
  EXPECT_TRUE(
      says("t = 67108864 s: rounding of the drivers, so late or after so many turns: condition "))
      << err_;
  EXPECT_FALSE(says("singular")) << err_;
}

}  // namespace
}  // namespace desmo::accuracy_test
