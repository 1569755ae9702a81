// desmo with a library that has MA27, or should have it.

#include "tests/cli/program.h"

namespace desmo::ma27_test {
namespace {

struct WithMa27 : Cli {
  ~WithMa27() override { ::unsetenv("DESMO_LIBCOINHSL"); }
  /// Names this file as the library.
  void use(const char* library) { ::setenv("DESMO_LIBCOINHSL", library, 1); }
};

TEST_F(WithMa27, ListsAndSolves) {
  const std::string solve = "solve slider_crank --quiet --formulation global_automatic_";
  const std::vector<std::string> expected = lines_of(solve + "klu");
  use(DESMO_MA27_DOUBLE);
  expect_printed("list formulations", "global_automatic_ma27", "group_automatic_ma27",
                 "group_symbolic_ma27");
  EXPECT_EQ(err_, "");
  printed(solve + "ma27");
  expect_rows(expected);
}

TEST_F(WithMa27, SaysWhatLibrariesDoNotServe) {
  const std::pair<const char*, const char*> useless[] = {
      {"/nonexistent/libcoinhsl.so", "DESMO_LIBCOINHSL names what cannot be loaded: /nonexistent/"},
      {DESMO_MA27_INCOMPLETE, "it has no ma27bd_"}};
  for (const auto& [library, complaint] : useless) {
    use(library);
    expect_said(0, "list", "desmo: no formulation with ma27: ", complaint);
    EXPECT_FALSE(prints("ma27"));
    expect_said(64, "solve slider_crank --formulation group_automatic_ma27/guess:linear",
                "formulation 'group_automatic_ma27': ", complaint);
    for (const char* not_asked_for : {"list cases", "solve slider_crank --quiet"}) {
      printed(not_asked_for);
      EXPECT_EQ(err_, "") << not_asked_for;
    }
  }
}

}  // namespace
}  // namespace desmo::ma27_test
