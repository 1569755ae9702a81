// One record in Markdown and HTML: every entry shows the numbers of its tables in both. The files
// are read back by code that shares nothing with what wrote them.
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
  for (const std::string& escape : escapes)
    text = replaced_everywhere(text, escape, escape.substr(1));
  for (const auto& [from, to] :
       {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}, {"−", "-"}})
    text = replaced_everywhere(text, from, to);
  return text;
}

std::string from_markdown(const std::string& text) {
  return unescaped(replaced_everywhere(text, "<br>", ""),
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
    for (const std::string entry : {"</th>", "</td>"})
      row = replaced_everywhere(row, entry, between + entry);
    rows.push_back(from_html(row));
    rows.back().resize(rows.back().size() - std::string(between).size());
    at = end;
  }
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

/// Expects an entry to show its digits; less the counts that people read in the notes below a
/// table. Returns how many they are.
std::size_t compare(const Column& column, const Entry& entry) {
  std::vector<std::string> digits;
  for (std::size_t i = 0; i < std::min(entry.digits.size(), column.quantities.size()); ++i)
    if (!entry.digits[i].empty() && column.quantities[i] != "repetitions")
      digits.push_back(entry.digits[i]);
  EXPECT_EQ(shown_numbers(entry), digits) << entry.shown;
  return digits.size();
}

void expect_same_numbers(const Document& document, std::size_t min_numbers = 100) {
  const std::string markdown = to_markdown(document), html = to_html(document);
  Rows expected, words;
  std::size_t numbers = 0;
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
      SCOPED_TRACE(table.name);
      for (const auto& row : table.rows)
        for (std::size_t i = 0; i < row.size(); ++i)
          if (!table.columns[i].quantities.empty()) numbers += compare(table.columns[i], row[i]);
    }
  }
  EXPECT_GT(numbers, min_numbers);
  EXPECT_EQ(rows_of_markdown(markdown), expected);
  EXPECT_EQ(rows_of_html(html), expected);
  for (const std::string& text : {from_markdown(markdown), from_html(html)})
    for (const std::string& line : words) EXPECT_CONTAINS(text, unescaped(line, {}));
}

TEST(SameNumbers, OfEverySample) {
  Json failures = complete_record();
  fail_candidate(failures, 336, "group_symbolic_lapack");
  set_samples(failures, 114, "group_automatic_klu", {0.04});
  erase_candidate(failures, 447, "group_automatic_klu");
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

}  // namespace
}  // namespace desmo::report::same_numbers_test
