// The scripts: seven, each with a help that needs nothing built, and none that ignores a mistake.

#include <fstream>
#include <set>
#include <vector>

#include "tests/started.h"

namespace desmo::scripts_test {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> scripts{
    ".ci/run",      "bench/check",          "bench/run", "bench/setup", "tests/run",
    "tests/format", "report/figures/render"};

/// environment: settings of variables, for the shell.
Ended run_script(const std::string& script, const std::string& arguments,
                 const std::string& environment = "") {
  return run(environment + DESMO_SOURCE_DIR "/" + script + " " + arguments);
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
      const Ended help = run_script(script, option);
      EXPECT_EQ(help.code, 0) << script << help.text;
      EXPECT_CONTAINS(help.text, "\n  " + script) << script << help.text;
      EXPECT_LACKS(help.text, "set -eu") << script;
      EXPECT_LACKS(help.text, "Building") << script;
    }
}

TEST(Scripts, NameTheArgumentThatTheyDoNotKnow) {
  for (const std::string& script : scripts) {
    const Ended refused = run_script(script, "no_such_thing");
    EXPECT_EQ(refused.code, 64) << script << refused.text;
    EXPECT_CONTAINS(refused.text, script + ": ");
    EXPECT_CONTAINS(refused.text, "'no_such_thing'");
  }
  for (const auto& [script, arguments] : {std::pair{"bench/run", "precision --quick"},
                                          {"bench/run", "size --peers"},
                                          {"bench/check", "--base"},
                                          {"bench/check", "--base no_such_commit"},
                                          {"bench/check", "--baseline=/nonexistent.json"},
                                          {"bench/check", "--baseline --time"},
                                          {"bench/check", "--history no_such_commit"},
                                          {"bench/check", "--history HEAD --slow head:a/1/b:3"},
                                          {"bench/check", "HEAD --history"},
                                          {"report/figures/render", "--packages ."}})
    EXPECT_EQ(run_script(script, arguments).code, 64) << script << ' ' << arguments;
}

/// A folder of programs that stand before the system's: nothing is installed, the user is root, and
/// apt-get notes its arguments and answers by `answer`, a piece of shell.
class Setup : public InFolder {
 protected:
  Ended setup(const std::string& answer) const {
    add("dpkg-query", "exit 1");
    add("id", "echo 0");
    add("apt-get",
        "echo \"$@\" >>" + file("calls") + "; n=$(wc -l <" + file("calls") + "); " + answer);
    return run_script("bench/setup", "counts", "PATH=" + folder_.string() + ":\"$PATH\" ");
  }
  std::vector<std::string> called() const {
    std::ifstream in(file("calls"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
  }

 private:
  void add(const std::string& name, const std::string& text) const {
    fs::permissions(write(name, "#!/bin/sh\n" + text + "\n"), fs::perms::owner_all);
  }
};

TEST_F(Setup, WaitsForAnotherAptGet) {
  // As apt-get 2.6 says it of each of its locks: the lists', that of what it downloads, and dpkg's.
  const Ended ended = setup(R"sh(case $n in
    1) echo "E: Could not get lock /var/lib/apt/lists/lock. It is held by process 7 (apt-get)" >&2
       echo "E: Unable to lock directory /var/lib/apt/lists/" >&2; exit 100 ;;
    3) echo "E: Could not get lock /var/cache/apt/archives/lock." >&2; exit 100 ;;
    esac)sh");
  EXPECT_EQ(ended.code, 0) << ended.text;
  EXPECT_CONTAINS(ended.text, "Waiting for another apt-get");
  const std::vector<std::string> calls = called();
  ASSERT_EQ(calls.size(), 4u);
  for (const int update : {0, 1}) EXPECT_TRUE(calls[update].ends_with(" update"));
  for (const int install : {2, 3}) {
    EXPECT_TRUE(calls[install].ends_with(" valgrind")) << calls[install];
    EXPECT_CONTAINS(calls[install], "DPkg::Lock::Timeout=");
  }
}

TEST_F(Setup, EndsWhereAptGetFails) {
  const Ended ended = setup("echo 'E: Unable to fetch some archives' >&2; exit 100");
  EXPECT_EQ(ended.code, 69);
  EXPECT_CONTAINS(ended.text, "Unable to fetch");
  EXPECT_EQ(called().size(), 1u);
}

}  // namespace
}  // namespace desmo::scripts_test
