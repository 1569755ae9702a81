// Compilers that are missing, fail or take too long, and how programs are run.

#include "formulations/runtime/compiler.h"

#include <fcntl.h>
#include <unistd.h>

#include <sstream>
#include <system_error>

#include "formulations/runtime/descriptor.h"
#include "formulations/runtime/program.h"
#include "tests/load/loading.h"

namespace desmo::load::compiler_test {
namespace {

using CompilerTest = Loading;

TEST_F(CompilerTest, ThatIsMissingIsNamed) {
  ::setenv("CXX", "/no/such/compiler", 1);
  expect_problem("CXX=/no/such/compiler: no such program");
  ::setenv("CXX", "no-such-compiler", 1);
  expect_problem("CXX=no-such-compiler");
  ::setenv("CXX", "./compiler", 1);
  expect_problem("CXX=./compiler");
  ::setenv("CXX", "/bin/false", 1);
  expect_problem("/bin/false: does not say its version");
}

TEST_F(CompilerTest, IsTheOneThatDesmoWasBuiltWithUnlessAnotherIsNamed) {
  ::unsetenv("CXX");
  EXPECT_EQ(Compiler::find().file(), DESMO_COMPILER);
  const fs::path link = folder_ / "my-c++";
  fs::create_symlink(DESMO_COMPILER, link);
  const std::string path = ::getenv("PATH");
  ::setenv("PATH", (":relative:" + folder_.string() + ":" + path).c_str(), 1);
  ::setenv("CXX", "my-c++", 1);
  const Compiler named = Compiler::find();
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(named.file(), link.string());
  EXPECT_NE(named.version(), "");
  EXPECT_CONTAINS(named.identity(), "-O3");
  EXPECT_CONTAINS(named.identity(), named.version());
}

TEST_F(CompilerTest, ThatFailsIsQuoted) {
  use_compiler("echo 'in error.h' >&2; echo 'kernels.cpp:1: error: no space left' >&2; exit 1");
  expect_problem("cannot compile the kernels: kernels.cpp:1: error: no space left");
  use_compiler("exit 0");
  expect_problem(": succeeds but makes no library; set CXX to a C++ compiler");
  use_compiler(
      "while [ $# -gt 0 ]; do [ \"$1\" = -o ] && echo 'no library' >\"$2\"; shift; done; exit 0");
  expect_problem("compiled kernels cannot be loaded");
  EXPECT_EQ(cached("").size(), cached(".cpp").size()) << "no library";
}

TEST_F(CompilerTest, ThatTakesTooLongIsEndedWithAllThatItHasStarted) {
  const fs::path started = folder_ / "started";
  use_compiler("sleep 600 &\necho $! >'" + started.string() + "'\nwait");
  // More time where a busy machine has not even started it.
  for (int seconds = 2; seconds <= 128 && text_of(started).empty(); seconds *= 4) {
    limit_ = std::chrono::seconds(seconds);
    expect_problem("ended after " + std::to_string(seconds) + " s");
  }
  ASSERT_FALSE(text_of(started).empty());
  const std::string sleeper = "/proc/" + std::to_string(std::stoi(text_of(started))) + "/stat";
  const auto sleeps = [&] {
    const std::string state = text_of(sleeper);
    return !state.empty() && state.substr(state.rfind(')')).find('Z') == std::string::npos;
  };
  for (int i = 0; i < 6000 && sleeps(); ++i) ::usleep(10000);
  EXPECT_FALSE(sleeps()) << text_of(sleeper);
}

struct Programs : testing::Test {
  Descriptor root{::open("/", O_RDONLY | O_DIRECTORY | O_CLOEXEC)};

  ProgramEnd run(const std::vector<std::string>& arguments, int milliseconds = 60000) {
    return run_program(arguments, root.number(), std::chrono::milliseconds(milliseconds));
  }
};

TEST_F(Programs, GetTheirArgumentsAsTheyAre) {
  const ProgramEnd ending = run({"/bin/echo", "$(touch /tmp/pwned); `x`", "*", "a\nb", "\"'"});
  EXPECT_TRUE(ending.good);
  EXPECT_EQ(ending.output, "$(touch /tmp/pwned); `x` * a\nb \"'\n");
  EXPECT_EQ(run({"/bin/pwd"}).output, "/\n");
  EXPECT_FALSE(run({"/bin/false"}).good);
  EXPECT_THROW(run({"/no/such/program"}), std::system_error);
}

TEST_F(Programs, RunInTheirFolderWhereStandardInputIsClosed) {
  const Descriptor input(::dup(STDIN_FILENO));
  ::dup2(root.number(), STDIN_FILENO);  // the number that open() gives a folder there
  const ProgramEnd ending =
      run_program({"/bin/pwd"}, STDIN_FILENO, std::chrono::milliseconds(60000));
  if (input.is_open())
    ::dup2(input.number(), STDIN_FILENO);
  else
    ::close(STDIN_FILENO);
  EXPECT_EQ(ending.output, "/\n");
}

TEST_F(Programs, GetLittleOfOurEnvironment) {
  ::setenv("CPATH", "/somewhere", 1);
  const std::string output = run({"/usr/bin/env"}).output;
  ::unsetenv("CPATH");
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    const std::string name = line.substr(0, line.find('='));
    EXPECT_TRUE(name == "LC_ALL" || name == "PATH" || name == "HOME" || name == "TMPDIR") << line;
  }
  EXPECT_CONTAINS(output, "LC_ALL=C\n");
}

TEST_F(Programs, AreReadToTheirEndAndNoFurther) {
  const ProgramEnd ending = run({"/bin/sh", "-c", "head -c 1000000 /dev/zero; echo >&2; exit 3"});
  EXPECT_FALSE(ending.good);
  EXPECT_FALSE(ending.late);
  EXPECT_EQ(ending.output, std::string(65536, '\0'));
  EXPECT_EQ(run({"/bin/cat"}).output, "") << "nothing comes from standard input";
}

TEST_F(Programs, AreEndedWhenTheirTimeIsOverEvenWhenTheySayNothingMore) {
  for (const char* commands :
       {"sleep 600", "exec >&- 2>&-; sleep 600", "trap '' TERM; sleep 600"}) {
    const auto start = std::chrono::steady_clock::now();
    const ProgramEnd ending = run({"/bin/sh", "-c", commands}, 200);
    EXPECT_TRUE(ending.late) << commands;
    EXPECT_FALSE(ending.good) << commands;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60)) << commands;
  }
}

}  // namespace
}  // namespace desmo::load::compiler_test
