#include <algorithm>
#include <numeric>

#include "report/formats/formats.h"

namespace desmo::report {
namespace {

constexpr std::size_t line_width = 100;

// Divides a text into pieces that stay on one line: words with the blank after them, and parts of
// ids up to "/". An interval in brackets is not divided.
std::vector<std::string> pieces(const std::string& text) {
  std::vector<std::string> result{""};
  bool inside = false;
  for (const char c : text) {
    result.back() += c;
    inside = c == '[' || (inside && c != ']');
    if (!inside && (c == ' ' || c == '/')) result.emplace_back();
  }
  return result;
}

std::string without_last_space(std::string text) {
  text.resize(text.find_last_not_of(' ') + 1);
  return text;
}

std::size_t min_width(const std::string& text) {
  std::size_t longest = 0;
  for (const std::string& piece : pieces(text))
    longest = std::max(longest, characters(without_last_space(piece)));
  return longest;
}

// Returns a text in lines of at most `width` characters, as far as its pieces allow.
std::vector<std::string> lines_of(const std::string& text, std::size_t width) {
  std::vector<std::string> lines{""};
  for (const std::string& piece : pieces(text)) {
    if (!lines.back().empty() &&
        characters(lines.back()) + characters(without_last_space(piece)) > width) {
      lines.back() = without_last_space(lines.back());
      lines.emplace_back();
    }
    lines.back() += piece;
  }
  lines.back() = without_last_space(lines.back());
  return lines;
}

// Returns a text in lines that begin with `indent` and have at most line_width characters, as far
// as its pieces allow.
std::string wrapped(const std::string& text, const std::string& indent) {
  std::string result;
  for (const std::string& line : lines_of(text, line_width - indent.size()))
    result += indent + line + "\n";
  return result;
}

// Returns widths of columns with which a row fits into a line, as far as pieces() allow: no column
// gets narrower than its longest piece.
std::vector<std::size_t> column_widths(const Table& table) {
  std::vector<std::size_t> widths, least;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    widths.push_back(characters(table.columns[i].name));
    least.push_back(min_width(table.columns[i].name));
    for (const auto& row : table.rows) {
      widths[i] = std::max(widths[i], characters(row[i].shown));
      least[i] = std::max(least[i], min_width(row[i].shown));
    }
  }
  while (std::accumulate(widths.begin(), widths.end(), 2 * widths.size()) > line_width) {
    std::size_t widest = widths.size();
    for (std::size_t i = 0; i < widths.size(); ++i)
      if (widths[i] > least[i] && (widest == widths.size() || widths[i] > widths[widest]))
        widest = i;
    if (widest == widths.size()) break;
    --widths[widest];
  }
  return widths;
}

std::string aligned(const std::string& text, std::size_t width, bool right) {
  const std::string space(width - std::min(width, characters(text)), ' ');
  return right ? space + text : text + space;
}

std::string terminal_table(const Table& table) {
  const std::vector<std::size_t> widths = column_widths(table);
  const auto row_of = [&](auto text_of) {
    std::vector<std::vector<std::string>> entries;
    std::size_t height = 0;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      entries.push_back(lines_of(text_of(i), widths[i]));
      height = std::max(height, entries.back().size());
    }
    std::string result;
    for (std::size_t line = 0; line < height; ++line) {
      std::string text;
      for (std::size_t i = 0; i < widths.size(); ++i)
        text += "  " + aligned(line < entries[i].size() ? entries[i][line] : "", widths[i],
                               !table.columns[i].quantities.empty());
      result += without_last_space(std::move(text)) + "\n";
    }
    return result;
  };
  std::string text = wrapped(table.title, "  ") + "\n";
  text += row_of([&](std::size_t i) { return table.columns[i].name; });
  text += row_of([&](std::size_t i) { return std::string(widths[i], '-'); });
  for (const auto& row : table.rows) text += row_of([&](std::size_t i) { return row[i].shown; });
  for (const std::string& note : table.notes) text += wrapped(note, "  ");
  return text;
}

std::string underlined(const std::string& title, char line) {
  return title + "\n" + std::string(characters(title), line) + "\n";
}

/// Returns the words of a section, with `space` before each paragraph, and its tables. Adds the
/// names of tables that are details, which it leaves out, to left_out.
std::string terminal_section(const Section& section, const char* space, std::string& left_out) {
  std::string text;
  for (const auto* paragraphs : {&section.paragraphs, &section.definitions})
    for (const std::string& paragraph : *paragraphs) text += space + wrapped(paragraph, "");
  for (const Table& table : section.tables)
    if (table.detail)
      left_out += (left_out.empty() ? "" : ", ") + table.name;
    else
      text += "\n" + terminal_table(table);
  return text;
}

}  // namespace

std::string to_terminal(const Document& document) {
  std::string text = underlined(document.title, '=');
  for (const Section& section : document.sections) {
    std::string left_out;
    text += "\n" + underlined(section.title, '-') + terminal_section(section, "\n", left_out);
    if (!left_out.empty())
      text += "\n" + wrapped("In the other formats only: " + left_out + ".", "");
  }
  return text;
}

std::string front_to_terminal(const Document& document) {
  std::string text = underlined(document.title, '=');
  std::string left_out;
  for (const Section& section : document.sections)
    if (section.front) text += "\n" + terminal_section(section, "", left_out);
  return text;
}

}  // namespace desmo::report
