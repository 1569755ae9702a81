// The page with its figures in a browser.
#include <fstream>

#include "report/formats/formats.h"
#include "tests/report/formats/references.h"
#include "tests/report/points_sample.h"
#include "tests/report/program.h"

namespace desmo::report::browser_test {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t size_limit = 2'000'000;  // bytes

// A page opened with Node.js and Chromium (bench/setup browser), as on a reader's computer.
class PageInBrowser : public Program {
 protected:
  // Returns whether the packages of a folder's lock file are there; out_ has the reason if not.
  bool installed(const std::string& lock_folder, const std::string& work) {
    const fs::path source = DESMO_SOURCE_DIR;
    return shell(std::string(DESMO_REPORT_RENDER) + " --packages " +
                 (source / lock_folder).string() + " " + (DESMO_BUILD_DIR "/" + work)) == 0;
  }

  void render(const fs::path& folder) {
    ASSERT_EQ(shell(std::string(DESMO_REPORT_RENDER) + " " + folder.string()), 0) << err_;
    ASSERT_NE(out_.find("rendered: report.html"), std::string::npos) << out_;
  }

  // The page of a record opened in Chromium; what open.mjs tells of it.
  Json opened(const fs::path& page) {
    const fs::path script = DESMO_SOURCE_DIR "/tests/report/browser/open.mjs",
                   copy = DESMO_BUILD_DIR "/browser/open.mjs";
    fs::copy_file(script, copy, fs::copy_options::overwrite_existing);
    EXPECT_EQ(shell("node " + copy.string() + " \"$(command -v chromium)\" " + page.string()), 0)
        << err_;
    return Json::parse(out_);
  }
};

// Returns the texts of the marks' hovers: the entries that a figure draws, as tables print them.
std::vector<std::string> drawn(const Table& table) {
  std::vector<std::string> texts;
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      if (table.drawn.empty() || table.drawn == table.columns[i].name) {
        if (table.columns[i].quantities.empty()) continue;  // a size is no mark
        if (table.figure == "requests" && row[i].note == "reference") continue;
        if (row[i].has_number())
          texts.push_back(row[i].shown);
        else if (table.figure == "work_precision")
          texts.push_back(row.back().shown);
      }
  std::sort(texts.begin(), texts.end());
  return texts;
}

void expect_answers(const Json& figure, const Table& table, const std::vector<std::string>& texts) {
  SCOPED_TRACE(table.name);
  EXPECT_EQ(figure["marks"], texts.size());
  std::vector<std::string> hovered = figure["texts"];
  std::sort(hovered.begin(), hovered.end());
  EXPECT_EQ(hovered, texts);  // every mark says its exact values
  EXPECT_TRUE(std::binary_search(texts.begin(), texts.end(), figure["pointer"]))
      << figure["pointer"];
  EXPECT_GT(figure["presses"], 0);  // the keyboard reaches the boxes
  EXPECT_LT(figure["marks_without_first"], figure["marks"]);
  EXPECT_GT(figure["marks_without_first"], 0);
  EXPECT_EQ(figure["marks_after_legend"], figure["marks"]);  // a click on the legend undoes it
}

constexpr double min_text = 10;  // px, of a figure at any width

// Nothing but tables and figures scrolls sideways, on a wide screen and on a phone, and paper shows
// every column.
void expect_nothing_lost(const Json& seen, const Document& document) {
  const auto tables = static_cast<std::size_t>(std::ranges::distance(tables_of(document)));
  EXPECT_EQ(seen["layout"].size(), 3u);
  for (const auto& [width, layout] : seen["layout"].items()) {
    EXPECT_EQ(layout["overflow"], 0) << width;
    EXPECT_EQ(layout["outside"], Json::array()) << width;
    EXPECT_EQ(layout["too_narrow"], Json::array()) << width;  // figures, of their column
    EXPECT_GE(layout["least_text"], min_text) << width;
    EXPECT_GE(layout["tables"], tables - seen["figures"].size())
        << width;  // some are data of figures
  }
  EXPECT_EQ(seen["cut_in_print"], Json::array());
}

TEST_F(PageInBrowser, FiguresAnswerWithoutARequestOrAnError) {
  if (!installed("report/figures", "figures")) GTEST_SKIP() << out_;
  Json json = in_known_schema(
      Json::parse(read_record_text(DESMO_SOURCE_DIR "/results/records/intel-xeon-paper.json.gz")));
  fail_candidate(json, 336, "group_symbolic_lapack");  // a gap, and one line more
  const fs::path recorded = folder_ / "record.json";
  std::ofstream(recorded) << json;
  const fs::path out = folder_ / "out", page = out / "report.html";
  const fs::path beside = DESMO_SOURCE_DIR "/results/records/amd-epyc-paper.json.gz";
  ASSERT_EQ(tables(recorded, "--out " + out.string() + " --beside " + beside.string()), 0);
  ASSERT_NO_FATAL_FAILURE(render(out));
  EXPECT_LE(fs::file_size(page), size_limit);
  expect_no_reference_outwards(read_text(page));
  EXPECT_LACKS(read_text(page), "Missing figure");

  if (shell("command -v chromium") != 0) GTEST_SKIP() << "Chromium is not installed";
  if (!installed("tests/report/browser", "browser")) GTEST_SKIP() << out_;
  const Json seen = opened(page);
  EXPECT_EQ(seen["requests"], Json::array());
  EXPECT_EQ(seen["errors"], Json::array());
  const Record record = record_from(json), other = read_record(beside);
  const Document document = make_report(record, {&other});
  expect_nothing_lost(seen, document);
  const Json& first = seen["first_screen"];  // sentences, figure and table, and all else folded
  for (const char* part : {"words", "figure", "table"}) {
    EXPECT_GT(first[part], 0) << part;
    EXPECT_LE(first[part], 900) << part;
  }
  EXPECT_GE(first["gap"], 0);  // px; the table follows the words at once
  EXPECT_LT(first["gap"], 60);
  EXPECT_GT(first["folded"], 5);
  std::size_t at = 0;
  for (const Table& table : tables_of(document))
    if (!table.figure.empty()) expect_answers(seen["figures"].at(at++), table, drawn(table));
  EXPECT_EQ(at, seen["figures"].size());
  EXPECT_GT(at, 5u);
}

TEST_F(PageInBrowser, TimeAgainstErrorAnswersToo) {
  if (!installed("report/figures", "figures")) GTEST_SKIP() << out_;
  const fs::path recorded = folder_ / "record.json", out = folder_ / "out";
  std::ofstream(recorded) << points_record();
  ASSERT_EQ(tables(recorded, "--out " + out.string()), 0);
  ASSERT_NO_FATAL_FAILURE(render(out));
  const auto files = files_in(out);
  ASSERT_NO_FATAL_FAILURE(render(out));  // over what is there
  EXPECT_EQ(files_in(out), files);
  ASSERT_EQ(tables(recorded, "--out " + out.string()), 0);  // and from the beginning
  ASSERT_NO_FATAL_FAILURE(render(out));
  EXPECT_EQ(files_in(out), files);
  expect_no_reference_outwards(read_text(out / "report.html"));
  if (shell("command -v chromium") != 0) GTEST_SKIP() << "Chromium is not installed";
  if (!installed("tests/report/browser", "browser")) GTEST_SKIP() << out_;
  const Json seen = opened(out / "report.html");
  EXPECT_EQ(seen["requests"], Json::array());
  EXPECT_EQ(seen["errors"], Json::array());
  expect_nothing_lost(seen, make_report(record_from(points_record())));
  ASSERT_EQ(seen["figures"].size(), 2u);
  const Table table = table_of(points_record(), "work_precision_truck_suspension");
  expect_answers(seen["figures"][0], table, drawn(table));  // it stands in front
}

}  // namespace
}  // namespace desmo::report::browser_test
