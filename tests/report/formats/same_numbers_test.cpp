// One record in CSV, Markdown and HTML: every number is that of its tables in all three. The
// files are read back by code that shares nothing with what wrote them.
#include <gtest/gtest-spi.h>

#include <charconv>
#include <sstream>

#include "report/formats/formats.h"
#include "tests/report/points_sample.h"
#include "tests/report/size_sample.h"

namespace desmo::report::same_numbers_test {
namespace {

using Rows = std::vector<std::string>;

constexpr const char* between = " | ";  // two entries of a row

/// Resolves escapes; every minus sign becomes a hyphen.
std::string unescaped(std::string text, const std::vector<std::string>& escapes) {
  for (const std::string& escape : escapes) text = replaced(text, escape, escape.substr(1));
  for (const auto& [from, to] :
       {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}, {"−", "-"}})
    text = replaced(text, from, to);
  return text;
}

std::string from_markdown(const std::string& text) {
  return unescaped(replaced(text, "<br>", ""),
                   {"\\`", "\\*", "\\_", "\\|", "\\[", "\\]", "\\~", "\\$", "\\#", "\\\\"});
}

std::string from_html(const std::string& text) {
  std::string result;
  bool inside = false;
  for (const char c : text) {
    inside = inside || c == '<';
    if (!inside) result += c;
    inside = inside && c != '>';
  }
  return unescaped(result, {});
}

Rows rows_of_markdown(const std::string& text) {
  Rows rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("| ") && !line.starts_with("| ---"))
      rows.push_back(from_markdown(line.substr(2, line.size() - 4)));
  return rows;
}

Rows rows_of_html(const std::string& text) {
  Rows rows;
  for (std::size_t at = 0; (at = text.find("<tr", at)) != text.npos;) {
    const std::size_t end = text.find("</tr>", at);
    std::string row = text.substr(at, end - at);
    for (const std::string entry : {"</th>", "</td>"}) row = replaced(row, entry, between + entry);
    rows.push_back(from_html(row));
    rows.back().resize(rows.back().size() - std::string(between).size());
    at = end;
  }
  return rows;
}

std::vector<std::vector<std::string>> rows_of_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {  // the last character ends the last line
    const char c = text[i];
    if (c == '"' && quoted && text[i + 1] == '"')
      rows.back().back() += text[i++];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      rows.back().emplace_back();
    else if (c == '\n' && !quoted)
      rows.push_back({""});
    else
      rows.back().back() += c;
  }
  for (auto& row : rows)  // an apostrophe keeps spreadsheets from reading a formula
    for (std::string& field : row)
      if (field.size() > 1 && field[0] == '\'' && std::string("=+-@").find(field[1]) != field.npos)
        field.erase(0, 1);
  return rows;
}

/// The numbers in a text, in order and as written: "1.2 [-3, 4e-5]" has three.
std::vector<std::string> numbers_in(const std::string& text) {
  std::vector<std::string> found;
  for (std::size_t at = 0; (at = text.find_first_of("0123456789", at)) != std::string::npos;) {
    if (at > 0 && text[at - 1] == '-') --at;
    const char* begin = text.data() + at;
    double value = 0;
    const auto end = std::from_chars(begin, text.data() + text.size(), value).ptr;
    found.emplace_back(begin, end);
    at += found.back().size();
  }
  return found;
}

/// The numbers shown of an entry, less its note, which stands behind the numbers or before them.
std::vector<std::string> shown_numbers(const Entry& entry) {
  for (const std::string& end : {entry.note, "(" + entry.note + ")"})
    if (entry.shown.ends_with(end))
      return numbers_in(entry.shown.substr(0, entry.shown.size() - end.size()));
  EXPECT_TRUE(entry.shown.starts_with(entry.note)) << entry.shown;
  return numbers_in(entry.shown.substr(entry.note.size()));
}

/// Expects the fields of a row of CSV to be an entry's quantities, and to be what it shows; less
/// the counts that people read in the notes below a table.
void compare(const Column& column, const Entry& entry, const std::vector<std::string>& fields,
             std::size_t& at, std::size_t& numbers) {
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < column.quantities.size(); ++i) {
    const std::string& field = fields.at(at++);
    const std::string digits = i < entry.digits.size() ? entry.digits[i] : "";
    EXPECT_TRUE(field == digits || (digits.empty() && field == entry.note)) << field;
    if (!digits.empty() && column.quantities[i] != "repetitions") shown.push_back(field);
  }
  EXPECT_EQ(shown_numbers(entry), shown) << entry.shown;
  numbers += shown.size();
}

std::size_t compare(const Table& table, const std::string& csv) {
  SCOPED_TRACE(table.name);
  const auto rows = rows_of_csv(csv);
  std::size_t numbers = 0;
  EXPECT_EQ(rows.size(), table.rows.size() + 1);
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows.front().size());
  for (std::size_t i = 0; i < table.rows.size() && i + 1 < rows.size(); ++i) {
    std::size_t at = 0;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      const Entry& entry = table.rows[i][k];
      if (table.columns[k].quantities.empty())
        EXPECT_EQ(rows[i + 1].at(at++), entry.shown);
      else
        compare(table.columns[k], entry, rows[i + 1], at, numbers);
    }
  }
  return numbers;
}

void expect_same_numbers(const Document& document, std::size_t min_numbers = 100) {
  const std::vector<NewFile> csv = render(document, "csv");
  const std::string markdown = to_markdown(document), html = to_html(document);
  Rows expected, words;
  std::size_t tables = 0, numbers = 0;
  for (const Section& section : document.sections) {
    for (const auto* texts : {&section.paragraphs, &section.definitions})
      words.insert(words.end(), texts->begin(), texts->end());
    for (const Table& table : section.tables) {
      words.push_back(table.title);
      words.insert(words.end(), table.notes.begin(), table.notes.end());
      const auto add = [&](const auto& row, auto member) {
        std::string text;
        for (std::size_t i = 0; i < row.size(); ++i)
          text += (i == 0 ? "" : between) + row[i].*member;
        expected.push_back(unescaped(text, {}));
      };
      add(table.columns, &Column::name);
      for (const auto& row : table.rows) add(row, &Entry::shown);
      ASSERT_LT(tables, csv.size());
      EXPECT_EQ(csv[tables].file_name, table.name + ".csv");
      numbers += compare(table, csv[tables++].content);
    }
  }
  EXPECT_EQ(tables, csv.size());
  EXPECT_GT(numbers, min_numbers);
  EXPECT_EQ(rows_of_markdown(markdown), expected);
  EXPECT_EQ(rows_of_html(html), expected);
  for (const std::string& text : {from_markdown(markdown), from_html(html)})
    for (const std::string& line : words) EXPECT_CONTAINS(text, unescaped(line, {}));
}

TEST(SameNumbers, OfEverySample) {
  Json failures = complete_record();
  fail_candidate(failures, truck, 336, "group_symbolic_lapack");
  set_samples(failures, 114, "group_automatic_klu", {0.04});
  erase_candidate(failures, truck, 447, "group_automatic_klu");
  for (const Json& json : {complete_record(), failures, points_record(), sizes_record()})
    expect_same_numbers(make_report(record_from(json)));
  expect_same_numbers(make_report(record_from(instructions_record())), 10);
}

TEST(SameNumbers, OfEveryFiledRun) {
  const auto records = read_records(DESMO_SOURCE_DIR "/results/records");
  for (const auto& [name, record] : records) {
    SCOPED_TRACE(name);
    expect_same_numbers(make_report(record), 50);
  }
  EXPECT_FALSE(records.empty());
}

// The comparison notices a digit and a text that differ, and a number that is not shown.
TEST(SameNumbers, DifferencesAreSeen) {
  const auto differences = [](const char* shown, const std::string& csv) {
    const Table table{.name = "one",
                      .title = "One",
                      .notes = {},
                      .columns = {{"id", {}}, {"time", {"seconds", "half_range"}}},
                      .rows = {{"a", {shown, {"1.50", "0.10"}, ""}}}};
    ::testing::TestPartResultArray found;
    const ::testing::ScopedFakeTestPartResultReporter reporter(
        ::testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &found);
    compare(table, csv);
    return found.size();
  };
  const std::string head = "id,time seconds,time half_range,notes\n";
  EXPECT_EQ(differences("1.50 ±0.10", head + "a,1.50,0.10,\n"), 0);
  EXPECT_EQ(differences("1.5 ±0.10", head + "a,1.50,0.10,\n"), 1);
  EXPECT_EQ(differences("1.50", head + "a,1.50,0.10,\n"), 1);
  EXPECT_EQ(differences("1.50 ±0.10", head + "b,1.50,0.1,\n"), 3);
  EXPECT_EQ(differences("1.50 ±0.10", head), 1);
}

}  // namespace
}  // namespace desmo::report::same_numbers_test
