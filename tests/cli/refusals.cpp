// Refusals of desmo, with their messages and exit codes.

#include <filesystem>
#include <fstream>
#include <set>

#include "cases/io/files.h"
#include "tests/cli/program.h"
#include "tests/overconstrained.h"
#include "tests/wheel.h"

namespace desmo::refusals_test {
namespace {

namespace fs = std::filesystem;

/// Constraints that were left out hold but for rounding or a coarse tolerance: the branch is right.
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
    expect_said(1, "solve far.json -o out/far --format " + std::string(format),
                "desmo: far.json: column 'theta', t = 20000 s: not a finite number");
    EXPECT_FALSE(fs::exists(out("far")));
  }
}

TEST_F(Cli, SaysWhenRoundingLeavesMoreThanTheTolerance) {
  write("fine.json", slider_crank(150, R"(, "time": {"end": 1, "step": 0.01},
    "tolerance": 1e-30)"));
  expect_said(0, "solve fine.json",
              "note: the tolerance 1e-30 is below what rounding leaves; positions were solved "
              "to ");
}

/// Three cranks carry a coupler where two would do; the third is too long for its drawing.
TEST_F(Cli, SaysInTheUnitsOfTheFileHowConstraintsContradictEachOther) {
  Mechanism cranks = parallel_cranks(1.1L, 17, true, 0.05L).mechanism;
  cranks.length_unit = "mm";
  write("cranks.json", write_mechanism(cranks));
  expect_said(65, "inspect cranks.json", "' is off by ", " mm at best");
  // A driver that goes 5.7 degrees asks for 2.9 of the other wheel, and for 2.3.
  const Wheel wheels{.couplings = R"("mesh": {"sum": {"a": 20, "w": 40}},
                                     "belt": {"sum": {"a": 20, "w": 50}})"};
  write("wheels.json", wheels.text());
  expect_said(65, "inspect wheels.json", "('a') moved by ", "5.7 deg, '",
              ": coupling' is off by 0.2", " deg at best, against '");
}

TEST_F(Cli, FailedRunsNameThePlaceAndLeaveNothing) {
  write("locks.json", locks);
  // 11 instants are within reach: it locks at 0.1024 s.
  expect_said(1, "solve locks.json -o out/motion.csv",
              "desmo: locks.json: group 'SG-II' (rod, slider), constraint '", "t = 0.11 s",
              "' is off by ", " mm; ");
  EXPECT_TRUE(fs::is_empty(folder_ / "out"));
  std::ofstream(out("motion.csv")) << "kept";
  EXPECT_EQ(desmo("solve locks.json -o out/motion.csv"), 1);
  EXPECT_EQ(text_of(out("motion.csv")), "kept");

  expect_said(1, "solve locks.json",
              "; keep the motion within reach ('desmo range' says how far each driver goes), "
              "or take smaller steps");
  EXPECT_EQ(lines().size(), 12u);
  EXPECT_TRUE(says("instants before it, on standard output: 11")) << err_;
  // A run without proofs tells the reasons apart all the same.
  expect_said(1, "solve locks.json --check none", "t = 0.11 s: no position was found (");
  EXPECT_TRUE(says("' is off by ") && !says("a position exists")) << err_;
}

/// Metres are written for millimetres: nothing steps to the first instant.
TEST_F(Cli, AStartFarFromTheDrawingIsNamed) {
  write("far.json", driven_slider(R"({"type": "constant", "value": 0.18})"));
  const std::string why = "; driver 's' starts at 0.18 mm, and is at 180 mm in the drawing";
  expect_said(1, "solve far.json", "t = 0 s: no position was found",
              why + " (a motion with \"from\": \"drawing\" counts from there); start nearer");
  EXPECT_FALSE(says("step")) << err_;
  expect_said(1, "range far.json", why + "; choose a start that can be assembled");
  expect_said(1, "solve far.json --units si",
              "; driver 's' starts at 0.00018 m, and is at 0.18 m in the drawing");
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
        "solve scene.json -o same.csv", "solve - --format csv -o scene.json <scene.json"})
    expect_said(64, command, "this is the scene, which is read; give another file");
  expect_said(64, "solve scene.json --format csv -o mechanism.json",
              "this is a file that the scene names, which is read");
  write("rows.csv", "0 0 360 0\n");
  expect_said(64, "solve scene.json --drivers rows.csv -o rows.csv",
              "this is the file of the drivers, which is read");
  EXPECT_EQ(text_of(folder_ / "scene.json"), scene);
  EXPECT_EQ(text_of(folder_ / "rows.csv"), "0 0 360 0\n");
  EXPECT_EQ(desmo("solve scene.json --quiet --format csv -o other.json"), 0) << err_;
}

TEST_F(Cli, InputThatIsWrong) {
  expect_said(66, "solve nowhere.json", "desmo: nowhere.json: there is no such file");
  EXPECT_EQ(desmo("solve ."), 66);
  expect_said(66, "inspect slider_crnk", "did you mean 'slider_crank'?");
  expect_said(64, "show slider_crnk", "did you mean 'slider_crank'?");

  write("half.json", locks.substr(0, 300));
  expect_said(65, "solve half.json", "desmo: half.json: line ");
  EXPECT_EQ(desmo("inspect half.json"), 65);
  write("list.json", "[1]");
  EXPECT_EQ(desmo("inspect list.json"), 65);
  expect_said(65, "solve - </dev/null", "desmo: standard input: ");
  ASSERT_EQ(desmo("show slider_crank >mechanism.json"), 0);
  expect_said(65, "solve mechanism.json", "says nothing of motion");

  const std::string loose = replaced(locks, R"("drivers": ["theta"])", R"("drivers": [])");
  write("loose.json",
        loose.substr(0, loose.find(R"("motion")")) + R"("time": {"end": 1, "step": 0.1}})");
  expect_said(65, "inspect loose.json", "desmo: loose.json: ", "under-constrained", "add a driver");
}

TEST_F(Cli, UsageErrors) {
  expect_said(64, "", "; 'desmo --help' shows what there is");
  expect_said(64, "inspekt slider_crank", "did you mean 'inspect'?");
  EXPECT_EQ(desmo("solve"), 64);
  EXPECT_EQ(desmo("solve slider_crank --no-such-option"), 64);
  EXPECT_EQ(desmo("solve slider_crank --format xml"), 64);
  expect_said(64, "solve truck_suspension", "has no number of axles; write truck_suspension:5");
  EXPECT_EQ(desmo("solve truck_suspension:0"), 64);
  EXPECT_EQ(desmo("solve truck_suspension:1x"), 64);
  expect_said(64, "solve slider_crank --formulation group_symbolic_kul",
              "did you mean 'group_symbolic_klu'?");
  expect_said(64, "solve slider_crank --formulation explicit",
              "did you mean 'group_symbolic_explicit', 'block_symbolic_explicit'?");
  expect_said(64, "solve slider_crank --out x.csv",
              "desmo: desmo solve has no option '--out'; did you mean '--output'?");
  expect_said(64, "range --jsn=1 slider_crank",
              "desmo range has no option '--jsn'; did you mean '--json'?");
  expect_said(
      64, "solve slider_crank x.csv",
      "desmo: 'x.csv': desmo solve takes no further argument; leave it out, or write -o before");
  EXPECT_EQ(desmo("range slider_crank x.csv y.csv"), 64);
  EXPECT_TRUE(says("desmo: 'x.csv': ") && !says("-o ")) << err_;
  expect_said(64, "tune slider_crank --max-error 1e-6 --level speed",
              "--level: 'speed' is none of its values; there are 'position', 'velocity', "
              "'acceleration'; 'desmo tune --help' shows what there is");
  EXPECT_EQ(out_, "");
  write("scene.json", slider_crank(150, R"(, "time": {"end": 1, "step": 0.1},
                                            "formulation": "magic")"));
  expect_said(65, "solve scene.json",
              "desmo: scene.json: /formulation: unknown formulation 'magic'");
  expect_printed("--help", "inspect", "Exit codes");
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
