#include "report/formats/formats.h"

#include <sstream>

#include "tests/report/sample.h"

namespace desmo::report::formats_test {
namespace {

// One table, with everything a format could stumble over.
Document awkward() {
  Table table{.name = "awkward",
              .title = "50 % of a_b",
              .notes = {"a | b"},
              .columns = {{"id", {}}, {"time", {"seconds", "spread"}}},
              .rows = {{"x_y|<z>, \"q\" --quick", {"-1.50 ±0.10", {"-1.50", "0.10"}, ""}},
                       {"[w] $5 & #1 {2} ~ ^ \\", note_entry(failed_mark)},
                       {"v", {"7.100 old", {"7.100", ""}, "old"}}}};
  return {.title = "T", .sections = {{"S", {"p_q"}, {table}}}};
}

TEST(Csv, QuotesAndMarks) {
  EXPECT_EQ(to_csv(awkward().sections[0].tables[0]),
            "id,time seconds,time spread,notes\n"
            "\"x_y|<z>, \"\"q\"\" --quick\",-1.50,0.10,\n"
            "[w] $5 & #1 {2} ~ ^ \\,FAILED,,\n"
            "v,7.100,,time: old\n");
}

// A text of a record never becomes a formula; numbers stay numbers.
TEST(Csv, HasNoFormulas) {
  for (const std::string begin : {"=", "+", "-", "@", "\t", "\r"}) {
    const std::string text = begin + "HYPERLINK(1)";
    const Table table{.columns = {{"id", {}}, {"time", {"seconds"}}},
                      .rows = {{text, note_entry(text)}, {"-1e3", {"-2 " + text, {"-2"}, text}}}};
    const std::string field = "'" + text, quoted = begin == "\r" ? "\"" + field + "\"" : field;
    EXPECT_EQ(to_csv(table), "id,time seconds,notes\n" + quoted + "," + quoted + ",\n-1e3,-2," +
                                 (begin == "\r" ? "\"time: " + text + "\"" : "time: " + text) +
                                 "\n");
  }
}

TEST(JsonFormat, HasNumbersAndNotes) {
  const Json json = Json::parse(to_json(awkward()));
  EXPECT_EQ(json["title"], "T");
  EXPECT_EQ(json["sections"][0]["paragraphs"], Json({"p_q"}));
  const Json& table = json["sections"][0]["tables"][0];
  EXPECT_EQ(table["name"], "awkward");
  EXPECT_EQ(table["notes"], Json({"a | b"}));
  const Json& rows = table["rows"];
  EXPECT_EQ(rows[0]["id"], "x_y|<z>, \"q\" --quick");
  EXPECT_EQ(rows[0]["time"], (Json{{"seconds", -1.5}, {"spread", 0.1}}));
  EXPECT_EQ(rows[1]["time"], (Json{{"seconds", nullptr}, {"spread", nullptr}, {"note", "FAILED"}}));
  EXPECT_EQ(rows[2]["time"], (Json{{"seconds", 7.1}, {"spread", nullptr}, {"note", "old"}}));
}

TEST(Markdown, Escapes) {
  const std::string text = to_markdown(awkward());
  EXPECT_CONTAINS(text, "| x\\_y\\|&lt;z&gt;, \"q\" --quick | -1.50 ±0.10 |");
  EXPECT_CONTAINS(text, "| \\[w\\] \\$5 &amp; \\#1 {2} \\~ ^ \\\\ | FAILED |");
  EXPECT_CONTAINS(text, "| --- | ---: |");
}

// A page cannot wrap what has no space, so long ids break before each setting; shorter ones stay
// whole.
TEST(Markdown, BreaksLongIds) {
  Document document = awkward();
  Table& table = document.sections[0].tables[0];
  const std::string forty = "abcdefghi/abcdefghi/abcdefghi/abcdefghi/";
  table.rows[0][0].shown = "a b " + forty;
  table.rows[1][0].shown = forty + "c";
  const std::string text = to_markdown(document);
  EXPECT_CONTAINS(text, "| a b " + forty + " |");
  EXPECT_CONTAINS(text, "| abcdefghi<br>/abcdefghi<br>/abcdefghi<br>/abcdefghi<br>/c |");
}

TEST(Formats, MeasureRowsInCharacters) {
  EXPECT_EQ(characters("±µ—a"), 4u);
  EXPECT_EQ(row_width(awkward().sections[0].tables[0]), 21u + 11u);
}

TEST(Terminal, AlignsByCharactersNotBytes) {
  const std::string text = to_terminal(awkward());
  EXPECT_CONTAINS(text, "-1.50 ±0.10\n");
  EXPECT_CONTAINS(text, "     FAILED\n");
}

std::size_t widest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, characters(line));
  return widest;
}

// An id breaks after "/", an interval stays whole.
TEST(Terminal, WrapsEntriesSoThatARowFits) {
  Document document = awkward();
  Table& table = document.sections[0].tables[0];
  const std::string id = "group_symbolic_explicit/guess:adams8/segments:8/tolerance:1e-10";
  table.rows[0][0].shown = id + "/" + id;
  table.rows[0][1].shown = "12.50 [12.25, 13.00] inconclusive";
  const std::string text = to_terminal(document);
  EXPECT_LE(widest_line(text), 100u) << text;
  EXPECT_CONTAINS(text, "[12.25, 13.00]");
  std::string without_spaces = text;
  std::erase_if(without_spaces, [](char c) { return c == ' ' || c == '\n'; });
  EXPECT_CONTAINS(without_spaces, "tolerance:1e-10") << text;
}

TEST(Terminal, ShowsInFrontWhatIsMarked) {
  Document document = awkward();
  EXPECT_EQ(front_to_terminal(document), "T\n=\n");
  document.sections[0].front = true;
  EXPECT_CONTAINS(front_to_terminal(document), "FAILED");
}

// bench/run prints the front at its end.
TEST(Terminal, FrontOfEveryFiledRecordFitsOnAScreen) {
  const auto records = read_records(DESMO_SOURCE_DIR "/results/records");
  for (const auto& [name, record] : records) {
    const std::string text = front_to_terminal(make_report(record));
    EXPECT_LE(std::ranges::count(text, '\n'), 56) << name << "\n" << text;
    EXPECT_LE(widest_line(text), 100u) << name << "\n" << text;
  }
  EXPECT_GE(records.size(), 8u);
}

TEST(Terminal, NamesTheTablesItLeavesOut) {
  Document document = awkward();
  document.sections[0].tables[0].detail = true;
  const std::string text = to_terminal(document);
  EXPECT_LACKS(text, "FAILED");
  EXPECT_CONTAINS(text, "In the other formats only: awkward.");
}

}  // namespace
}  // namespace desmo::report::formats_test
