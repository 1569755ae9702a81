// desmo view: one page that needs nothing else, its size, and when none is written.

#include <filesystem>
#include <string>

#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "tests/cli/view.h"

namespace desmo::viewing_test {
namespace {

namespace fs = std::filesystem;

TEST_F(View, IsOnePageThatLoadsNothing) {
  ASSERT_EQ(desmo("view slider_crank --quiet"), 0) << err_;
  EXPECT_EQ(err_, "");
  const std::string page = out_;
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_LE(page.size(), max_page);
  for (const char* loads : {"<link", "<img", "<iframe", "<script src", "@import"})
    EXPECT_EQ(page.find(loads), std::string::npos) << loads;
  EXPECT_GT(page.find("url("), page.find("</style>"));
  EXPECT_EQ(page.find("WebGLRenderer"), std::string::npos) << "a page needs no WebGL";
  EXPECT_EQ(printed("view slider_crank -o out/page.html"), "");
  EXPECT_TRUE(says("accuracy: 401 of 401 rows proven")) << err_;
  EXPECT_EQ(text_of(out("page.html")), page) << "the same bytes every time";
}

TEST_F(View, ThinsOutWhatIsTooLongAndSaysSo) {
  write("scene.json", slider_crank(150, R"(, "time": {"end": 100, "step": 0.005})"));
  ASSERT_EQ(desmo("view scene.json"), 0) << err_;
  EXPECT_LE(out_.size(), max_page);
  const Json data = data_of(out_);
  EXPECT_EQ(data["time"]["solved"], 20001);
  EXPECT_EQ(data["time"]["stride"], 4);
  EXPECT_EQ(data["shown"], 5001);
}

TEST_F(View, LeavesNothingHalfWritten) {
  write("mechanism.json", "{\"format\": \"desmo-mechanism\", \"version\": 1}");
  expect_said(65, "view mechanism.json -o out/page.html", "mechanism.json: /format");
  write("scene.json", slider_crank(150, R"(, "time": {"end": 1, "step": 0.1})"));
  expect_said(64, "view scene.json -o scene.json", "this is the scene, which is read");
  EXPECT_EQ(desmo("view nothing -o out/page.html"), 66);
  EXPECT_EQ(desmo("view slider_crank -o nowhere/page.html"), 74);
  expect_said(65, "view four_bar:1000 -o out/page.html",
              "a page cannot show a mechanism of 3003 coordinates");
  EXPECT_TRUE(fs::is_empty(out("")));
}

/// Returns the scene of a chain of four-bars that turns.
std::string chain(int four_bars, const std::string& time) {
  return R"({"format": "desmo-scene", "version": 2, "motion": {"crank/theta":
    {"type": "polynomial", "coefficients": [1, 1]}}, "time": )" +
         time + R"(, "mechanism": )" + write_mechanism(desmo::four_bar(four_bars).mechanism) + "}";
}

/// A page has room for some 20 instants of the short chain, and for 8 of the long one, which would
/// be solved for days.
TEST_F(View, RefusesWhatIsTooLargeBeforeItIsSolved) {
  write("long.json", chain(560, R"({"end": 1, "step": 1e-8})"));
  expect_said(65, "view long.json -o out/page.html",
              "a page cannot show a mechanism of 1683 coordinates");
  EXPECT_TRUE(fs::is_empty(out("")));
  write("short.json", chain(400, R"({"end": 0.1, "step": 0.001})"));
  ASSERT_EQ(desmo("view short.json -o out/page.html"), 0) << err_;
  const std::string page = text_of(out("page.html"));
  EXPECT_LE(page.size(), max_page);
  EXPECT_GE(data_of(page)["shown"], 16);
}

}  // namespace
}  // namespace desmo::viewing_test
