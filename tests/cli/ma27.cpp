// desmo with a library that has MA27, or should have it.

#include "tests/cli/program.h"

namespace desmo::ma27_test {
namespace {

struct WithMa27 : Cli {
  /// Runs desmo with this file named as the library.
  int desmo_with(const std::string& library, const std::string& arguments) {
    return shell("DESMO_LIBCOINHSL=" + library + " " DESMO_CLI " " + arguments);
  }
};

TEST_F(WithMa27, ListsAndSolves) {
  ASSERT_EQ(desmo_with(DESMO_MA27_DOUBLE, "list formulations"), 0) << err_;
  for (const char* id : {"global_automatic_ma27", "group_automatic_ma27", "group_symbolic_ma27"})
    EXPECT_TRUE(prints(id));
  EXPECT_EQ(err_, "");
  const std::string solve = "solve slider_crank --quiet --formulation global_automatic_";
  const std::vector<std::string> expected = lines_of(solve + "klu");
  ASSERT_EQ(desmo_with(DESMO_MA27_DOUBLE, solve + "ma27"), 0) << err_;
  expect_rows(expected);
}

TEST_F(WithMa27, SaysWhatLibrariesDoNotServe) {
  const std::string solve = "solve slider_crank --formulation group_automatic_ma27/guess:linear";
  const std::pair<const char*, const char*> useless[] = {
      {"/nonexistent/libcoinhsl.so", "DESMO_LIBCOINHSL names what cannot be loaded: /nonexistent/"},
      {DESMO_MA27_INCOMPLETE, "it has no ma27bd_"}};
  for (const auto& [library, complaint] : useless) {
    ASSERT_EQ(desmo_with(library, "list"), 0) << err_;
    EXPECT_FALSE(prints("ma27"));
    EXPECT_TRUE(says("desmo: no formulation with ma27: ")) << err_;
    EXPECT_TRUE(says(complaint)) << err_;
    EXPECT_EQ(desmo_with(library, "list cases"), 0);
    EXPECT_EQ(err_, "");

    EXPECT_EQ(desmo_with(library, solve), 64);
    EXPECT_TRUE(says("formulation 'group_automatic_ma27': ")) << err_;
    EXPECT_TRUE(says(complaint)) << err_;
    EXPECT_EQ(desmo_with(library, "solve slider_crank --quiet"), 0) << err_;
    EXPECT_EQ(err_, "") << "nobody asked for it";
  }
}

}  // namespace
}  // namespace desmo::ma27_test
