// What desmo refuses, with which message and exit code.

#include <filesystem>
#include <fstream>
#include <set>
#include <tuple>

#include "tests/cli/program.h"

namespace desmo::refusals_test {
namespace {

namespace fs = std::filesystem;

/// Steps of 2.5 rad end on another branch at first. What is told are the positions of short steps.
TEST_F(Cli, SolvesAStepAgainThatLeavesTheBranch) {
  const auto last_row = [&](const std::string& mechanism, const std::string& time) {
    write("leap.json", R"({"format": "desmo-scene", "version": 1, "mechanism": {"library": ")" +
                           mechanism + R"("},)" + time + "}");
    EXPECT_EQ(desmo("solve leap.json"), 0) << err_;
    EXPECT_FALSE(says("degraded") || says("jumps")) << err_;
    return numbers(lines().back());
  };
  const std::string turning = R"("motion": {"theta": {"type": "polynomial",
    "coefficients": [0.5, 1]}}, "request": [{"points": ["A"]}], "time": {"end": 5, "step": )";
  for (const auto& [mechanism, time, step, short_step] :
       {std::tuple{"rssr", turning, "2.5}", "0.025}"},
        std::tuple{"andrews", std::string(R"("time": {"end": 4, "step": )"), "1}", "0.01}"}}) {
    const std::vector<double> long_steps = last_row(mechanism, time + step),
                              short_steps = last_row(mechanism, time + short_step);
    ASSERT_EQ(long_steps.size(), short_steps.size());
    for (std::size_t i = 0; i < long_steps.size(); ++i)
      EXPECT_NEAR(long_steps[i], short_steps[i], 1e-8) << mechanism << ", column " << i;
  }
}

/// What rounding or a coarse tolerance leaves of constraints that were left out is no other branch.
TEST_F(Cli, SolvesAsCoarselyAsItIsAsked) {
  for (const char* name : {"slider_crank", "jansen_leg", "whitworth", "andrews"})
    for (const char* id : {"global_automatic_klu", "block_symbolic_explicit"})
      for (const char* settings : {"/tolerance:1e-6", "/guess:quadratic/tolerance:1e-4"})
        EXPECT_EQ(desmo("solve " + std::string(name) + " --quiet --no-compile --formulation " + id +
                        settings + " -o out/coarse.csv"),
                  0)
            << err_;
}

TEST_F(Cli, DeliversFiniteNumbersOnly) {
  std::string zeros;
  for (int i = 0; i < 50; ++i) zeros += "0, ";
  write("far.json", R"({"format": "desmo-scene", "version": 1,
    "mechanism": {"library": "slider_crank"}, "units": {"angle": "rad"},
    "motion": {"theta": {"type": "polynomial", "coefficients": [)" +
                        zeros + R"(1e99]}},
    "time": {"end": 3e4, "step": 1e4}, "request": [{"angles": ["theta"], "level": "velocity"}]})");
  for (const char* format : {"csv", "jsonl"}) {
    EXPECT_EQ(desmo("solve far.json -o out/far --format " + std::string(format)), 1);
    EXPECT_TRUE(says("desmo: far.json: column 'theta', t = 20000 s: not a finite number")) << err_;
    EXPECT_FALSE(fs::exists(out("far")));
  }
}

TEST_F(Cli, RefusesLimitsThatAreNoNumbers) {
  EXPECT_EQ(desmo("solve slider_crank --compile-limit nan"), 64);
  EXPECT_TRUE(says("--compile-limit: is not a number")) << err_;
  EXPECT_EQ(desmo("tune slider_crank --max-error nan"), 64);
  EXPECT_TRUE(says("--max-error: is not a number")) << err_;
}

TEST_F(Cli, SaysWhenRoundingLeavesMoreThanTheTolerance) {
  write("fine.json", slider_crank(150, R"(, "time": {"end": 1, "step": 0.01},
    "tolerance": 1e-30)"));
  EXPECT_EQ(desmo("solve fine.json"), 0);
  EXPECT_TRUE(
      says("note: the tolerance 1e-30 is below what rounding leaves; positions were solved "
           "to "))
      << err_;
}

/// Three cranks carry a coupler where two would do; the third is 2 mm too long for its drawing.
TEST_F(Cli, SaysInTheUnitsOfTheFileHowConstraintsContradictEachOther) {
  write("cranks.json", R"({"format": "desmo-mechanism", "version": 1, "name": "cranks",
    "dimension": 2, "units": {"length": "mm"},
    "points": {"A": [0, 0], "B": [40, 0], "C": [100, 0],
               "D": [12, 16], "E": [52, 16], "F": [113.2, 17.6]},
    "ground": {"points": ["A", "B", "C"]},
    "bodies": {"first": {"points": ["A", "D"]}, "second": {"points": ["B", "E"]},
               "third": {"points": ["C", "F"]}, "coupler": {"points": ["D", "E", "F"]}},
    "joints": [
      {"type": "revolute", "bodies": ["ground", "first"], "points": ["A"]},
      {"type": "revolute", "bodies": ["ground", "second"], "points": ["B"]},
      {"type": "revolute", "bodies": ["ground", "third"], "points": ["C"]},
      {"type": "revolute", "bodies": ["first", "coupler"], "points": ["D"]},
      {"type": "revolute", "bodies": ["second", "coupler"], "points": ["E"]},
      {"type": "revolute", "bodies": ["third", "coupler"], "points": ["F"]}],
    "coordinates": {"theta": {"angle": ["A", "D"]}}, "drivers": ["theta"]})");
  EXPECT_EQ(desmo("inspect cranks.json"), 65);
  EXPECT_TRUE(says("' is off by ")) << err_;
  EXPECT_TRUE(says(" mm at best")) << err_;
}

TEST_F(Cli, FailedRunsNameThePlaceAndLeaveNothing) {
  write("locks.json", locks);
  EXPECT_EQ(desmo("solve locks.json -o out/motion.csv"), 1);
  // 11 instants are within reach: it locks at 0.1024 s.
  for (const char* text : {"desmo: locks.json: group 'SG-II' (rod, slider), constraint '",
                           "t = 0.11 s", "' is off by ", " mm; "})
    EXPECT_TRUE(says(text)) << err_;
  EXPECT_TRUE(fs::is_empty(folder_ / "out"));
  std::ofstream(out("motion.csv")) << "kept";
  EXPECT_EQ(desmo("solve locks.json -o out/motion.csv"), 1);
  EXPECT_EQ(text_of(out("motion.csv")), "kept");

  EXPECT_EQ(desmo("solve locks.json"), 1);
  EXPECT_EQ(lines().size(), 12u);
  EXPECT_TRUE(says("instants before it, on standard output: 11")) << err_;
}

/// A slider-crank in millimetres, drawn at 180 mm, whose slider is driven.
std::string driven_slider(const std::string& motion) {
  std::string scene = slider_crank(150, R"(, "time": {"end": 1, "step": 0.5})");
  const auto replace = [&](const std::string& before, const std::string& after) {
    scene.replace(scene.find(before), before.size(), after);
  };
  replace(R"("B": [50, 0], "C": [200, 0])", R"("B": [30, 40], "C": [180, 0])");
  replace(R"("theta": {"angle": ["A", "B"]})", R"("s": {"distance": ["A", "C"], "along": "x"})");
  replace(R"(["theta"])", R"(["s"])");
  replace(R"("units": {"angle": "deg"},
  "motion": {"theta": {"type": "polynomial", "coefficients": [0, 360]}})",
          R"("units": {"length": "mm"}, "motion": {"s": )" + motion + "}");
  return scene;
}

/// Metres are written for millimetres: nothing steps to the first instant.
TEST_F(Cli, AStartFarFromTheDrawingIsNamed) {
  write("far.json", driven_slider(R"({"type": "constant", "value": 0.18})"));
  const std::string why = "; driver 's' starts at 0.18 mm, and is at 180 mm in the drawing";
  ASSERT_EQ(desmo("solve far.json"), 1);
  EXPECT_TRUE(says("t = 0 s: no position was found") &&
              says(why + " (a motion with \"from\": \"drawing\" counts from there); start nearer"))
      << err_;
  EXPECT_FALSE(says("step")) << err_;
  ASSERT_EQ(desmo("range far.json"), 1);
  EXPECT_TRUE(says(why + "; choose a start that can be assembled")) << err_;
  ASSERT_EQ(desmo("solve far.json --units si"), 1);
  EXPECT_TRUE(says("; driver 's' starts at 0.00018 m, and is at 0.18 m in the drawing")) << err_;
  write("near.json", driven_slider(R"({"type": "constant", "value": 175})"));
  ASSERT_EQ(desmo("solve near.json"), 0) << err_;
  write("rows", "0 0.18 0 0\n");
  ASSERT_EQ(desmo("solve near.json --drivers rows"), 1);
  EXPECT_TRUE(says("rows: line 1: ") && says(why) && !says("from")) << err_;
  // Later instants have a step that leads to them.
  write("rows", "0 175 0 0\n1 0.18 0 0\n");
  ASSERT_EQ(desmo("solve near.json --drivers rows"), 1);
  EXPECT_TRUE(says("rows: line 2: ") && !says("in the drawing")) << err_;
}

TEST_F(Cli, AMotionThatLocksNamesTheCommandThatSaysWhere) {
  write("locks.json", locks);
  EXPECT_EQ(desmo("solve locks.json"), 1);
  EXPECT_TRUE(
      says("; keep the motion within reach ('desmo range' says how far each driver goes), "
           "or take smaller steps"))
      << err_;
}

TEST_F(Cli, NothingThatIsReadIsReplaced) {
  ASSERT_EQ(desmo("show slider_crank >mechanism.json"), 0);
  const std::string scene = R"({"format": "desmo-scene", "version": 2,
    "mechanism": "mechanism.json", "motion": {"theta": {"type": "polynomial",
    "coefficients": [0, 360]}}, "time": {"end": 1, "step": 0.25}})";
  write("scene.json", scene);
  fs::create_symlink("scene.json", folder_ / "link");
  fs::create_hard_link(folder_ / "scene.json", folder_ / "same.csv");
  for (const char* command :
       {"solve scene.json --format csv -o scene.json", "solve scene.json --format csv -o ./link",
        "solve scene.json -o same.csv", "solve - --format csv -o scene.json <scene.json"}) {
    EXPECT_EQ(desmo(command), 64) << command;
    EXPECT_TRUE(says("this is the scene, which is read; give another file")) << command << err_;
  }
  EXPECT_EQ(desmo("solve scene.json --format csv -o mechanism.json"), 64);
  EXPECT_TRUE(says("this is a file that the scene names, which is read")) << err_;
  write("rows.csv", "0 0 360 0\n");
  EXPECT_EQ(desmo("solve scene.json --drivers rows.csv -o rows.csv"), 64);
  EXPECT_TRUE(says("this is the file of the drivers, which is read")) << err_;
  EXPECT_EQ(text_of(folder_ / "scene.json"), scene);
  EXPECT_EQ(text_of(folder_ / "rows.csv"), "0 0 360 0\n");
  EXPECT_EQ(desmo("solve scene.json --quiet --format csv -o other.json"), 0) << err_;
}

TEST_F(Cli, InputThatIsWrong) {
  EXPECT_EQ(desmo("solve nowhere.json"), 66);
  EXPECT_TRUE(says("desmo: nowhere.json: there is no such file")) << err_;
  EXPECT_EQ(desmo("solve ."), 66);
  EXPECT_EQ(desmo("inspect slider_crnk"), 66);
  EXPECT_TRUE(says("did you mean 'slider_crank'?")) << err_;
  EXPECT_EQ(desmo("show slider_crnk"), 64);
  EXPECT_TRUE(says("did you mean 'slider_crank'?")) << err_;

  write("half.json", locks.substr(0, 300));
  EXPECT_EQ(desmo("solve half.json"), 65);
  EXPECT_TRUE(says("desmo: half.json: line ")) << err_;
  EXPECT_EQ(desmo("inspect half.json"), 65);
  write("list.json", "[1]");
  EXPECT_EQ(desmo("inspect list.json"), 65);
  EXPECT_EQ(desmo("solve - </dev/null"), 65);
  EXPECT_TRUE(says("desmo: standard input: ")) << err_;
  ASSERT_EQ(desmo("show slider_crank >mechanism.json"), 0);
  EXPECT_EQ(desmo("solve mechanism.json"), 65);
  EXPECT_TRUE(says("says nothing of motion")) << err_;

  std::string loose = locks;
  loose.replace(loose.find(R"("drivers": ["theta"])"), 20, R"("drivers": [])");
  loose.replace(loose.find(R"("motion")"), std::string::npos,
                R"("time": {"end": 1, "step": 0.1}})");
  write("loose.json", loose);
  EXPECT_EQ(desmo("inspect loose.json"), 65);
  EXPECT_TRUE(says("desmo: loose.json: ") && says("under-constrained") && says("add a driver"))
      << err_;
}

TEST_F(Cli, UsageErrors) {
  EXPECT_EQ(desmo(""), 64);
  EXPECT_EQ(desmo("inspekt slider_crank"), 64);
  EXPECT_TRUE(says("did you mean 'inspect'?")) << err_;
  EXPECT_EQ(desmo("solve"), 64);
  EXPECT_EQ(desmo("solve slider_crank --no-such-option"), 64);
  EXPECT_EQ(desmo("solve slider_crank --format xml"), 64);
  EXPECT_EQ(desmo("solve truck_suspension"), 64);
  EXPECT_EQ(desmo("solve truck_suspension:0"), 64);
  EXPECT_EQ(desmo("solve truck_suspension:1x"), 64);
  EXPECT_EQ(desmo("solve slider_crank --formulation group_symbolic_kul"), 64);
  EXPECT_TRUE(says("did you mean 'group_symbolic_klu'?")) << err_;
  EXPECT_EQ(desmo("solve slider_crank --formulation explicit"), 64);
  EXPECT_TRUE(says("did you mean 'group_symbolic_explicit', 'block_symbolic_explicit'?")) << err_;
  EXPECT_EQ(desmo("solve slider_crank --out x.csv"), 64);
  EXPECT_TRUE(says("desmo: desmo solve has no option '--out'; did you mean '--output'?")) << err_;
  EXPECT_EQ(desmo("range --jsn=1 slider_crank"), 64);
  EXPECT_TRUE(says("desmo range has no option '--jsn'; did you mean '--json'?")) << err_;
  EXPECT_EQ(desmo("solve slider_crank x.csv"), 64);
  EXPECT_TRUE(says("desmo: 'x.csv': desmo solve takes nothing after") && says("-o before")) << err_;
  EXPECT_EQ(desmo("range slider_crank x.csv y.csv"), 64);
  EXPECT_TRUE(says("desmo: 'x.csv': ") && !says("-o ")) << err_;
  EXPECT_EQ(desmo("tune slider_crank --max-error 1e-6 --level speed"), 64);
  EXPECT_TRUE(
      says("--level: 'speed' is none of its values; there are 'position', 'velocity', "
           "'acceleration'"))
      << err_;
  EXPECT_EQ(out_, "");
  write("scene.json", slider_crank(150, R"(, "time": {"end": 1, "step": 0.1},
                                            "formulation": "magic")"));
  EXPECT_EQ(desmo("solve scene.json"), 65);
  EXPECT_TRUE(says("desmo: scene.json: /formulation: unknown formulation 'magic'")) << err_;
  EXPECT_EQ(desmo("--help"), 0);
  EXPECT_TRUE(prints("inspect") && prints("Exit codes"));
  std::set<std::string> examples;
  for (const char* command : {"list", "show", "inspect", "solve", "view", "range", "tune"}) {
    ASSERT_EQ(desmo(std::string(command) + " --help"), 0);
    const std::size_t begin = out_.find("Examples:\n");
    ASSERT_NE(begin, std::string::npos) << command;
    EXPECT_NE(out_.find("desmo " + std::string(command), begin), std::string::npos) << command;
    EXPECT_TRUE(examples.insert(out_.substr(begin)).second) << command;
    EXPECT_FALSE(prints("ENUM") || prints("->") || prints("Exit codes")) << out_;
  }
  EXPECT_EQ(desmo("--version"), 0);
  EXPECT_TRUE(out_.starts_with("desmo ")) << out_;
}

}  // namespace
}  // namespace desmo::refusals_test
