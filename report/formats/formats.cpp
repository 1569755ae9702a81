#include "report/formats/formats.h"

#include <algorithm>
#include <stdexcept>

namespace desmo::report {
namespace {

std::string markdown_text(const std::string& text) {
  std::map<char, std::string> escapes{{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}};
  for (const char c : std::string_view("\\`*_|[]~$#")) escapes[c] = {'\\', c};
  return escaped(text, escapes);
}

// Largest number of characters without a blank in an entry that is left unbroken.
constexpr std::size_t max_unbroken = 40;

/// Returns the text of an entry. Where a word is longer than max_unbroken, such as an id with many
/// settings, a line ends before each "/", so that no column is wider than a page.
std::string markdown_entry(const std::string& text) {
  std::string entry = markdown_text(text);
  std::size_t word = 0, longest = 0;
  for (const char c : text) longest = std::max(longest, word = c == ' ' ? 0 : word + 1);
  return longest > max_unbroken ? escaped(entry, {{'/', "<br>/"}}) : entry;
}

std::string markdown_table(const Table& table) {
  std::string header = "|", rule = "|", rows;
  for (const Column& column : table.columns) {
    header += " " + markdown_text(column.name) + " |";
    rule += column.quantities.empty() ? " --- |" : " ---: |";
  }
  for (const auto& row : table.rows) {
    rows += "|";
    for (const Entry& entry : row) rows += " " + markdown_entry(entry.shown) + " |";
    rows += "\n";
  }
  std::string text =
      "**" + markdown_text(table.title) + "**\n\n" + header + "\n" + rule + "\n" + rows;
  for (const std::string& note : table.notes) text += "\n" + markdown_text(note) + "\n";
  return text;
}

}  // namespace

std::string to_markdown(const Document& document) {
  std::string text = "# " + markdown_text(document.title) + "\n";
  for (const Section& section : document.sections) {
    text += "\n## " + markdown_text(section.title) + "\n";
    for (const auto* paragraphs : {&section.paragraphs, &section.definitions})
      for (const std::string& paragraph : *paragraphs)
        text += "\n" + markdown_text(paragraph) + "\n";
    for (const Table& table : section.tables) text += "\n" + markdown_table(table);
  }
  return text;
}

std::string escaped(std::string_view text, const std::map<char, std::string>& escapes) {
  std::string result;
  for (const char c : text)
    if (const auto escape = escapes.find(c); escape != escapes.end())
      result += escape->second;
    else
      result += c;
  return result;
}

// Counts all bytes except for continuation bytes.
std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::size_t row_width(const Table& table) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    std::size_t longest = 0;
    for (const auto& row : table.rows) longest = std::max(longest, characters(row[i].shown));
    width += longest;
  }
  return width;
}

std::vector<NewFile> render(const Document& document, const std::string& format) {
  if (format == "terminal") return {{"tables.txt", to_terminal(document)}};
  if (format == "json") return {{"tables.json", to_json(document)}};
  if (format == "markdown") return {{"tables.md", to_markdown(document)}};
  if (format == "html") return {{"report.html", to_html(document)}};
  if (format != "csv") throw std::invalid_argument("no such format: " + format);
  std::vector<NewFile> files;
  for (const Table& table : tables_of(document))
    files.push_back({table.name + ".csv", to_csv(table)});
  return files;
}

namespace {

/// Returns a document whose tables have their names in a first column, where there are several.
Document with_names_in_rows(Document document) {
  if (std::ranges::distance(tables_of(document)) < 2) return document;
  for (Table& table : tables_of(document)) {
    table.columns.insert(table.columns.begin(), {"table", {}});
    for (auto& row : table.rows) row.insert(row.begin(), table.name);
  }
  return document;
}

}  // namespace

std::string printed(const Document& document, const std::vector<std::string>& formats) {
  std::string text;
  for (const std::string& format : formats) {
    const bool is_csv = format == "csv";
    for (const NewFile& file : render(is_csv ? with_names_in_rows(document) : document, format))
      text += (is_csv && !text.empty() ? "\n" : "") + file.content;
  }
  return text;
}

}  // namespace desmo::report
