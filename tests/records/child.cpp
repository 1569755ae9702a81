// Other programs: the environment that they get, and what their end tells.

#include "bench/kit/process/child.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace desmo::bench::child_test {
namespace {

TEST(Launch, PassesOnWhereLibrariesAre) {
  ::setenv("DESMO_LIBCOINHSL", "/some/libcoinhsl.so", 1);
  const std::vector<std::string> all = fixed_launch({"program"}).environment;
  ::unsetenv("DESMO_LIBCOINHSL");
  EXPECT_EQ(std::ranges::count(all, "DESMO_LIBCOINHSL=/some/libcoinhsl.so"), 1);
}

TEST(Child, WhoseExitCodeIsLostIsNoSuccess) {
  std::string output;
  EXPECT_EQ(Child(fixed_launch({"/bin/false"})).finish(output), 1);
  const auto handled = std::signal(SIGCHLD, SIG_IGN);
  EXPECT_THROW(Child(fixed_launch({"/bin/false"})).finish(output), std::runtime_error);
  std::signal(SIGCHLD, handled);
}

}  // namespace
}  // namespace desmo::bench::child_test
