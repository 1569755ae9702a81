#include "report/formats/formats.h"

#include <algorithm>
#include <stdexcept>

namespace desmo::report {

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
