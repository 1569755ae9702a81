// Quotations of filed records in the repository's pages, and the length of the front page.
#include <sstream>

#include "tests/report/formats/references.h"
#include "tests/report/program.h"

namespace desmo::report::quotations_test {
namespace {

namespace fs = std::filesystem;

// Returns a text in one line, with a space between words.
std::string in_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string result;
  for (std::string word; words >> word;) result += (result.empty() ? "" : " ") + word;
  return result;
}

// A page's text between its comments <!-- measured: RECORD --> and <!-- end of measured -->.
struct Quotation {
  std::string record, text;
};

std::vector<Quotation> quotations(const std::string& page) {
  const std::string mark = "<!-- measured: ", end_mark = "<!-- end of measured -->";
  EXPECT_EQ(count(page, mark), count(page, end_mark));
  EXPECT_TRUE(count(page, mark) == 0 || page.rfind(mark) < page.rfind(end_mark));
  std::vector<Quotation> found;
  for (const std::string& quoted : texts_between(page, mark, end_mark)) {
    const std::size_t end = quoted.find(" -->");
    found.push_back({quoted.substr(0, end), quoted.substr(end + 4)});
  }
  return found;
}

// Pages quote records: each line of their tables is a line of that record's report, and what they
// quote with ">" is what stands in front of it.
TEST_F(Program, PagesQuoteTheirRecords) {
  struct Page {
    const char* name;
    std::size_t records, rows;  // quoted; rows at least
  };
  const fs::path source = DESMO_SOURCE_DIR;
  for (const Page& page : {Page{"README.md", 4, 6}, Page{"formulations/accuracy.md", 1, 9}}) {
    SCOPED_TRACE(page.name);
    const std::vector<Quotation> quoted = quotations(read_text(source / page.name));
    EXPECT_EQ(quoted.size(), page.records) << page.name;
    std::size_t rows = 0;
    for (const auto& [record, text] : quoted) {
      ASSERT_EQ(tables(source / record, "--format markdown"), 0);
      const std::string report = out_;
      std::string sentences;
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(">")) sentences += line.substr(1) + "\n";
        if (!line.starts_with("|")) continue;
        ++rows;
        EXPECT_CONTAINS(report, "\n" + line + "\n") << page.name << ": " << line;
      }
      ASSERT_EQ(tables(source / record), 0);
      EXPECT_CONTAINS(in_one_line(out_), in_one_line(sentences)) << page.name << ": " << sentences;
    }
    EXPECT_GE(rows, page.rows) << page.name;
  }
}

// The front page stays one that is read in minutes: at most 750 words outside tables and code, and
// one short table of results.
TEST_F(Program, TheFrontPageIsShort) {
  std::istringstream lines(read_text(fs::path(DESMO_SOURCE_DIR) / "README.md"));
  std::size_t tables = 0, rows = 0;
  bool measured = false, code = false;
  std::string words;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("<!-- ")) measured = line.starts_with("<!-- measured: ");
    const bool fence = line.starts_with("```"), row = line.starts_with("|");
    if (fence) code = !code;
    if (!row) rows = 0;
    if (!row && !code && !fence && !line.starts_with("    ") && !line.starts_with("<!--"))
      words += line + "\n";
    if (!row || !measured) continue;
    tables += rows++ == 0;
    EXPECT_LE(rows, 12u) << line;  // ten, the header and the line below it
  }
  EXPECT_EQ(tables, 1u);
  const std::string text = in_one_line(words);
  EXPECT_LT(std::ranges::count(text, ' '), 750);
  for (std::istringstream stream(text); stream >> words;)
    EXPECT_TRUE(words.size() <= 40 || words.find("](") != std::string::npos ||
                words.find("http") == 0)
        << words << " belongs in a table or in code";
}

}  // namespace
}  // namespace desmo::report::quotations_test
