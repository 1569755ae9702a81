// desmo solve: code for a mechanism that the program does not know, and what happens without.

#include "tests/cli/program.h"
#include "tests/own_mechanism.h"

namespace desmo::own_code_test {
namespace {

constexpr const char* explicit_order = "solve own.json --formulation group_symbolic_explicit ";

struct OwnCode : Cli {
  OwnCode() { write("own.json", swinging_plates(1, one_second)); }
  /// A compiler that knows its version and then does this.
  void write_compiler(const std::string& commands) {
    write("compiler",
          "#!/bin/sh\n[ \"$1\" = --version ] && { echo mine 1.0; exit 0; }\n" + commands);
    std::filesystem::permissions(folder_ / "compiler", std::filesystem::perms::owner_all);
  }
  std::string with_compiler() const {
    return "env CXX=" + file("compiler") + " " DESMO_CLI " " + explicit_order;
  }
};

TEST_F(OwnCode, IsMadeOnceAndGivesTheSameAnswer) {
  ASSERT_EQ(desmo("solve own.json --formulation group_automatic_klu"), 0) << err_;
  EXPECT_FALSE(says("note:")) << err_;
  const std::vector<std::string> expected = lines();

  expect_said(0, explicit_order, "note: code for a/SG-", "a/SG-II (7 unknowns)", ": compiled by /");
  EXPECT_FALSE(says("automatically")) << err_;
  expect_rows(expected);

  expect_said(0, explicit_order, ": from " + (folder_ / "desmo/kernels").string());
  EXPECT_FALSE(says("compiled")) << err_;
  expect_rows(expected);
  ASSERT_EQ(desmo(explicit_order + std::string("--quiet")), 0);
  EXPECT_EQ(err_, "");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "pwned")) << "what the title says is not done";
}

TEST_F(OwnCode, IsNotMadeUnlessItsFormulationIsNamed) {
  expect_said(0, "solve own.json", "note: no generated code for ",
              "with --formulation to have it generated");
  expect_said(0, explicit_order + std::string("--no-compile"), "note: no generated code for ");
  EXPECT_FALSE(says("to have it generated")) << err_;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "desmo"));
  write("own.json",
        swinging_plates(1, one_second + R"(, "formulation": "block_symbolic_inlined")"));
  expect_said(0, "solve own.json", "note: code for ");
}

/// The program's own code for such blocks has pivots that suit a truck's.
TEST_F(OwnCode, IsMadeWhereOtherCodeRefusesStepsWhoseCostIsTold) {
  write("own.json",
        text_of(DESMO_SOURCE_DIR "/tests/load/scenes/double_cardan_wrong_phase.scene.json"));
  expect_said(0, "solve own.json",
              "to a more general solver, some 10 times slower; the numbers are as exact (name "
              "a formulation with --formulation to have better code generated)");
  expect_said(0, "solve own.json --formulation block_symbolic_inlined", "note: code for ");
  EXPECT_FALSE(says("general solver")) << err_;
}

TEST_F(OwnCode, IsDoneWithoutWhereThereIsNoCompiler) {
  const std::string expected = printed(explicit_order + std::string("--no-compile"));
  const auto expect_notes = [&](const std::string& why) {
    EXPECT_TRUE(says("note: no code for a/SG-")) << err_;
    EXPECT_TRUE(says(why)) << err_;
    EXPECT_TRUE(says("evaluated automatically")) << err_;
    EXPECT_EQ(out_, expected);
  };
  ASSERT_EQ(shell("CXX=/no/compiler " DESMO_CLI " " + std::string(explicit_order)), 0) << err_;
  expect_notes("CXX=/no/compiler: no such program");

  write_compiler("sleep 600");
  ASSERT_EQ(shell(with_compiler() + "--compile-limit 0.2"), 0);
  expect_notes("ended after 0.2 s");

  EXPECT_EQ(desmo(explicit_order + std::string("--compile-limit 0")), 64);
  expect_said(64, explicit_order + std::string("--compile-limit nan"),
              "--compile-limit: is not a number");
}

TEST_F(OwnCode, IsWhatTuneChoosesFrom) {
  expect_said(0, "tune own.json --max-error 1e-8 --write", "note: code for a/SG-II (7 unknowns)");
  const std::string id = lines().at(0);
  EXPECT_NE(id.find("_symbolic_"), std::string::npos) << id << ": nothing else is as fast";
  ASSERT_EQ(desmo("solve own.json"), 0) << err_;
  EXPECT_FALSE(says("automatically")) << err_;
}

TEST_F(OwnCode, RefusesNamesThatAreNone) {
  for (const char* name :
       {"a\\\"b", "a\\nb", "$(touch pwned)", "`x`", "-o", "*/ x", "?\?/", " a"}) {
    write("own.json", replaced_everywhere(swinging_plates(1, one_second), "a/Q1", name));
    expect_said(65, explicit_order, "is not a name");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "pwned"));
  }
}

TEST_F(OwnCode, LetsNoCompilerOutliveAnInterruption) {
  write_compiler("echo $$ >'" + (folder_ / "started").string() + "'\nsleep 600");
  const auto started = [&] { return text_of(folder_ / "started").find('\n') != std::string::npos; };
  ASSERT_EQ(interrupt(with_compiler() + "--quiet -o out/motion.csv", SIGTERM, started),
            128 + SIGTERM);
  const std::string state =
      "/proc/" + std::to_string(std::stoi(text_of(folder_ / "started"))) + "/stat";
  EXPECT_TRUE(comes_true([&] {  // it has ended, or nobody has waited for it yet
    const std::string text = text_of(state);
    return text.empty() || text.substr(text.rfind(')')).find('Z') != std::string::npos;
  }));
  EXPECT_FALSE(std::filesystem::exists(out("motion.csv")));
}

}  // namespace
}  // namespace desmo::own_code_test
