// The page: what stands in it before it has figures.
#include "report/formats/formats.h"
#include "tests/report/formats/references.h"
#include "tests/report/sample.h"

namespace desmo::report::page_test {
namespace {

std::string page_of(const Json& record) { return to_html(make_report(record_from(record))); }

TEST(Page, RefersToNothingOutsideItself) {
  const std::string page = page_of(requests_record());
  expect_no_reference_outwards(page);
  EXPECT_LACKS(page, "<script");
  EXPECT_CONTAINS(page, "default-src 'none'");
}

// A table's id is also the name of its file.
void expect_links_to_places_that_exist_once(const std::string& page) {
  std::vector<std::string> ids = texts_between(page, " id=\"");
  const std::size_t all = ids.size();
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  EXPECT_EQ(ids.size(), all);
  std::vector<std::string> targets = texts_between(page, "href=\"#");
  for (const std::string& label : texts_between(page, "aria-labelledby=\""))
    targets.push_back(label);
  EXPECT_GT(targets.size(), 10u);
  for (const std::string& target : targets)
    EXPECT_TRUE(std::binary_search(ids.begin(), ids.end(), target)) << target;
}

TEST(Page, LinksLeadToPlacesThatExistOnce) {
  for (const Json& record : {requests_record(), complete_record()})
    expect_links_to_places_that_exist_once(page_of(record));
}

// For those who hear the page: every table has a name, every candidate a row and a column with a
// header.
TEST(Page, TablesHaveCaptionsAndHeaders) {
  const Document document = make_report(record_from(requests_record()));
  const std::string page = to_html(document);
  std::size_t tables = 0, rows = 0, columns = 0;
  for (const Table& table : tables_of(document)) {
    ++tables;
    rows += table.rows.size();
    columns += table.columns.size();
  }
  EXPECT_EQ(count(page, "<caption id="), tables);
  EXPECT_EQ(count(page, "<th scope=\"row\">"), rows);
  EXPECT_EQ(count(page, "<th scope=\"col\""), columns);
}

// The order is: the words of what was found, the figure, the tables, and definitions, folded.
TEST(Page, BeginsWithWhatWasFoundAndFoldsDefinitions) {
  const Table table{.name = "t", .title = "T", .notes = {"Note"}, .columns = {{"id", {}}}};
  Table drawn = table;
  drawn.name = "f", drawn.figure = "figure6", drawn.caption = "Caption.";
  for (const bool front : {true, false}) {
    const std::string page = to_html(
        {"D", {{"S", {"It was found."}, {drawn, table}, {}, front, {"A word means this."}}}});
    const std::string body = page.substr(page.find("<main"));
    std::size_t last = 0;
    for (const char* part :
         {"It was found.", "Caption.</figcaption>", "<!-- f -->", "<details>", "Note", "</figure>",
          "<table id=\"t\"", "<details>", "A word means this.", "</details>"}) {
      const std::size_t at = body.find(part, last);
      EXPECT_NE(at, std::string::npos) << part << " in " << body;
      last = std::min(at, body.size());
    }
  }
}

TEST(Page, EscapesWhatTheRecordSays) {
  Json record = complete_record();
  record["record"]["machine"]["cpu"] = "<script>alert(\"x\")</script> <!-- figure5 --> & co";
  const std::string page = page_of(record);
  EXPECT_LACKS(page, "<script");
  EXPECT_EQ(count(page, "<!-- figure5 -->"), 1u);
  EXPECT_CONTAINS(page, "&lt;!-- figure5 --&gt; &amp; co");
}

TEST(Page, TellsVerdictsFromNumbers) {
  Table table{.name = "t",
              .title = "T",
              .columns = {{"id", {}}, {"n", {"value", "low"}}},
              .rows = {{"a", {"1.5 [1.0] in", {"1.5", "1.0"}, inside_mark}},
                       {"b", note_entry(failed_mark)}}};
  const std::string page = to_html({"D", {{"S", {}, {table}}}});
  EXPECT_CONTAINS(page,
                  "1.5<span class=\"rest interval\"> [1.0] </span><span class=\"in\">in</span>");
  EXPECT_CONTAINS(page, "<span class=\"failed\">FAILED</span>");
}

}  // namespace
}  // namespace desmo::report::page_test
