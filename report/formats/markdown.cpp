#include "report/formats/formats.h"

namespace desmo::report {
namespace {

std::string markdown_text(const std::string& text) {
  std::map<char, std::string> escapes{{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}};
  for (const char c : std::string_view("\\`*_|[]~$#")) escapes[c] = {'\\', c};
  return escaped(text, escapes);
}

std::string markdown_table(const Table& table) {
  std::string header = "|", rule = "|", rows;
  for (const Column& column : table.columns) {
    header += " " + markdown_text(column.name) + " |";
    rule += column.quantities.empty() ? " --- |" : " ---: |";
  }
  for (const auto& row : table.rows) {
    rows += "|";
    for (const Entry& entry : row) rows += " " + markdown_text(entry.shown) + " |";
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

}  // namespace desmo::report
