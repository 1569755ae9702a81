#include <algorithm>

#include "report/formats/formats.h"

namespace desmo::report {
namespace {

constexpr std::size_t line_width = 100;

// Lines of at most line_width characters, each after `indent`.
std::string wrapped(const std::string& text, const std::string& indent) {
  std::string result, line = indent;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t space = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, space - at);
    if (line.size() > indent.size() && characters(line) + 1 + characters(word) > line_width) {
      result += line + "\n";
      line = indent;
    }
    line += (line.size() > indent.size() ? " " : "") + word;
    at = space + 1;
  }
  return result + line + "\n";
}

std::string aligned(const std::string& text, std::size_t room, bool right, bool last) {
  const std::string space(room - std::min(room, characters(text)), ' ');
  if (right) return space + text;
  return last ? text : text + space;
}

std::string terminal_table(const Table& table) {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    widths.push_back(characters(table.columns[i].name));
    for (const auto& row : table.rows) widths[i] = std::max(widths[i], characters(row[i].shown));
  }
  const auto line = [&](auto text_of) {
    std::string result;
    for (std::size_t i = 0; i < widths.size(); ++i)
      result += "  " + aligned(text_of(i), widths[i], !table.columns[i].quantities.empty(),
                               i + 1 == widths.size());
    return result + "\n";
  };
  std::string text = wrapped(table.title, "  ") + "\n";
  text += line([&](std::size_t i) { return table.columns[i].name; });
  text += line([&](std::size_t i) { return std::string(widths[i], '-'); });
  for (const auto& row : table.rows) text += line([&](std::size_t i) { return row[i].shown; });
  for (const std::string& note : table.notes) text += wrapped(note, "  ");
  return text;
}

}  // namespace

std::string to_terminal(const Document& document) {
  std::string text = document.title + "\n" + std::string(characters(document.title), '=') + "\n";
  for (const Section& section : document.sections) {
    text += "\n" + section.title + "\n" + std::string(characters(section.title), '-') + "\n";
    for (const std::string& paragraph : section.paragraphs) text += "\n" + wrapped(paragraph, "");
    std::string left_out;
    for (const Table& table : section.tables) {
      if (table.detail)
        left_out += (left_out.empty() ? "" : ", ") + table.name;
      else
        text += "\n" + terminal_table(table);
    }
    if (!left_out.empty())
      text += "\n" + wrapped("In the other formats only: " + left_out + ".", "");
  }
  return text;
}

}  // namespace desmo::report
