#include "report/formats/formats.h"

#include <algorithm>
#include <stdexcept>

namespace desmo::report {
namespace {

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string line(const std::vector<std::string>& fields) {
  std::string text;
  for (std::size_t i = 0; i < fields.size(); ++i) text += (i == 0 ? "" : ",") + field(fields[i]);
  return text + "\n";
}

}  // namespace

std::string to_csv(const Table& table) {
  std::vector<std::string> names;
  bool numbers = false;
  for (const Column& column : table.columns) {
    if (column.quantities.empty()) names.push_back(column.name);
    for (const std::string& quantity : column.quantities)
      names.push_back(column.name + " " + quantity);
    numbers = numbers || !column.quantities.empty();
  }
  if (numbers) names.push_back("notes");
  std::string text = line(names);

  for (const auto& row : table.rows) {
    std::vector<std::string> fields;
    std::string notes;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Column& column = table.columns[i];
      const Entry& entry = row[i];
      if (column.quantities.empty()) {
        fields.push_back(entry.shown);
        continue;
      }
      std::vector<std::string> digits = entry.digits;
      digits.resize(column.quantities.size());
      if (!entry.has_number())
        digits.front() = entry.note;
      else if (!entry.note.empty())
        notes += (notes.empty() ? "" : "; ") + column.name + ": " + entry.note;
      fields.insert(fields.end(), digits.begin(), digits.end());
    }
    if (numbers) fields.push_back(notes);
    text += line(fields);
  }
  return text;
}

namespace {

std::string markdown_text(const std::string& text) {
  std::map<char, std::string> escapes{{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}};
  for (const char c : std::string_view("\\`*_|[]~$#")) escapes[c] = {'\\', c};
  return escaped(text, escapes);
}

constexpr std::size_t max_unbroken =
    40;  // characters that a cell may have without a place to break

/// Returns the text of a cell. Where it has a word that is too long, an id with many settings, a
/// line ends before each of them: no column may be wider than a page.
std::string markdown_cell(const std::string& text) {
  std::string cell = markdown_text(text);
  std::size_t word = 0, longest = 0;
  for (const char c : text) longest = std::max(longest, word = c == ' ' ? 0 : word + 1);
  return longest > max_unbroken ? escaped(cell, {{'/', "<br>/"}}) : cell;
}

std::string markdown_table(const Table& table) {
  std::string header = "|", rule = "|", rows;
  for (const Column& column : table.columns) {
    header += " " + markdown_text(column.name) + " |";
    rule += column.quantities.empty() ? " --- |" : " ---: |";
  }
  for (const auto& row : table.rows) {
    rows += "|";
    for (const Entry& entry : row) rows += " " + markdown_cell(entry.shown) + " |";
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
    for (const std::string& paragraph : section.paragraphs)
      text += "\n" + markdown_text(paragraph) + "\n";
    for (const Table& table : section.tables) text += "\n" + markdown_table(table);
  }
  return text;
}

const std::vector<std::string>& format_names() {
  static const std::vector<std::string> names{"terminal", "csv", "markdown", "html"};
  return names;
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

// Continuation bytes take no room.
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
  if (format == "markdown") return {{"tables.md", to_markdown(document)}};
  if (format == "html") return {{"report.html", to_html(document)}};
  if (format != "csv") throw std::invalid_argument("no such format: " + format);
  std::vector<NewFile> files;
  for (const Section& section : document.sections)
    for (const Table& table : section.tables) files.push_back({table.name + ".csv", to_csv(table)});
  return files;
}

std::string printed(const Document& document, const std::vector<std::string>& formats) {
  std::string text;
  for (const std::string& format : formats)
    for (const NewFile& file : render(document, format)) {
      if (format == "csv") text += (text.empty() ? "# " : "\n# ") + file.file_name + "\n";
      text += file.content;
    }
  return text;
}

}  // namespace desmo::report
