// The scripts: seven, each with a help that needs nothing built, and none that ignores a mistake.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <string>

namespace desmo::scripts_test {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> scripts{
    ".ci/run",      "bench/check",          "bench/run", "bench/setup", "tests/run",
    "tests/format", "report/figures/render"};

struct Ended {
  int code;
  std::string text;  ///< standard output and standard error
};

Ended run(const std::string& script, const std::string& arguments) {
  const std::string command = DESMO_SOURCE_DIR "/" + script + " " + arguments + " 2>&1";
  FILE* const pipe = popen(command.c_str(), "r");
  Ended ended;
  for (int c; (c = std::fgetc(pipe)) != EOF;) ended.text += static_cast<char>(c);
  const int status = pclose(pipe);
  ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ended;
}

TEST(Scripts, AreSeven) {
  std::set<std::string> found;
  for (const char* folder : {".ci", "bench", "cases", "formulations", "report", "results", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(DESMO_SOURCE_DIR) / folder))
      if (entry.is_regular_file() &&
          (entry.status().permissions() & fs::perms::owner_exec) != fs::perms::none)
        found.insert(fs::relative(entry.path(), DESMO_SOURCE_DIR).string());
  EXPECT_EQ(found, scripts);
}

TEST(Scripts, PrintTheirHelpAndNothingElse) {
  for (const std::string& script : scripts)
    for (const char* option : {"--help", "-h"}) {
      const Ended help = run(script, option);
      EXPECT_EQ(help.code, 0) << script << help.text;
      EXPECT_NE(help.text.find("\n  " + script), std::string::npos) << script << help.text;
      EXPECT_EQ(help.text.find("set -eu"), std::string::npos) << script;
      EXPECT_EQ(help.text.find("Building"), std::string::npos) << script;
    }
}

TEST(Scripts, NameTheArgumentThatTheyDoNotKnow) {
  for (const std::string& script : scripts) {
    const Ended refused = run(script, "no_such_thing");
    EXPECT_EQ(refused.code, 64) << script << refused.text;
    EXPECT_NE(refused.text.find(script + ": "), std::string::npos) << refused.text;
    EXPECT_NE(refused.text.find("'no_such_thing'"), std::string::npos) << refused.text;
  }
  EXPECT_EQ(run("bench/run", "precision --quick").code, 64);
  EXPECT_EQ(run("bench/run", "size --peers").code, 64);
  EXPECT_EQ(run("bench/check", "--base").code, 64);
  EXPECT_EQ(run("bench/check", "--base no_such_commit").code, 64);
  EXPECT_EQ(run("bench/check", "--baseline=/nonexistent.json").code, 64);
  EXPECT_EQ(run("bench/check", "--baseline --time").code, 64);
  EXPECT_EQ(run("bench/check", "--history no_such_commit").code, 64);
  EXPECT_EQ(run("bench/check", "--history HEAD --slow head:a/1/b:3").code, 64);
  EXPECT_EQ(run("bench/check", "HEAD --history").code, 64);
  EXPECT_EQ(run("report/figures/render", "--packages .").code, 64);
}

}  // namespace
}  // namespace desmo::scripts_test
