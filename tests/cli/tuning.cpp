// desmo tune: what it promises, what it writes, and when it has nothing to offer.

#include "tests/cli/program.h"

namespace desmo::tuning_test {
namespace {

TEST_F(Cli, TunesASceneAndStoresTheChoice) {
  const std::string before = slider_crank(150, R"(, "time": {"end": 0.5, "step": 0.01})");
  write("mine.json", before);
  ASSERT_EQ(desmo("tune mine.json --max-error 1e-6 --write --quiet"), 0) << err_;
  EXPECT_EQ(err_, "");
  const std::string id = lines().at(0);
  EXPECT_TRUE(prints("relative error over the motion: position ")) << out_;
  const std::string after = text_of(folder_ / "mine.json");
  EXPECT_EQ(after, before.substr(0, before.size() - 1) + ",\n  \"formulation\": \"" + id + "\"}");
  expect_printed("solve mine.json --format jsonl", id);  // solve obeys
}

TEST_F(Cli, TunesWithinABudget) {
  expect_printed("tune slider_crank --budget 1s --quiet",
                 "each of these is more accurate than every faster one");
}

TEST_F(Cli, SaysWhenNothingIsAccurateOrFastEnough) {
  expect_said(1, "tune slider_crank --max-error 1e-19 --quiet",
              "nothing holds a relative position error of 1e-19; the most accurate is ",
              "conditioning sets a floor of the order of ");
  expect_said(1, "tune slider_crank --budget 0.001ns --quiet",
              "nothing takes at most 1e-06 us a step here; the fastest is ");
}

/// A rod of 49 cannot follow a crank of 50 over a full turn.
TEST_F(Cli, TuneSaysThatAMotionCannotBeSolved) {
  write("locks.json", slider_crank(49, R"(, "time": {"end": 1, "step": 0.01})"));
  expect_said(1, "tune locks.json --max-error 1e-6 --no-compile --quiet",
              "desmo: locks.json: short, group 'SG-II': no reference solution at t = 0.22",
              "; choose a motion that 'desmo solve' proves");
}

TEST_F(Cli, TuneIsToldWhatToDo) {
  const std::pair<const char*, const char*> wrong[] = {
      {"tune slider_crank", "give either --max-error or --budget"},
      {"tune slider_crank --max-error 1e-6 --budget 1us", "give either --max-error or --budget"},
      {"tune slider_crank --max-error 0", "--max-error: must be positive and finite; "},
      {"tune slider_crank --max-error inf", "--max-error: must be positive and finite; "},
      {"tune slider_crank --max-error nan", "--max-error: is not a number; "},
      {"tune slider_crank --max-error small", "--max-error: is not a number; "},
      {"tune slider_crank --budget -1us", "--budget: must be positive and finite; "},
      {"tune slider_crank --budget 50", "--budget"},
      {"tune slider_crank --max-error 1e-6 --write", "is not a scene file"},
  };
  for (const auto& [arguments, message] : wrong) expect_said(64, arguments, message);
  write("position.json", slider_crank(150, R"(, "time": {"end": 0.5, "step": 0.01},
    "request": [{"points": ["C"], "level": "position"}])"));
  expect_said(64, "tune position.json --max-error 1e-6 --level velocity",
              "the scene does not ask for any");
}

}  // namespace
}  // namespace desmo::tuning_test
