#include "bench/cli/text.h"

#include <algorithm>
#include <ranges>
#include <sstream>

#include "cases/mechanism/formatted.h"
#include "cases/mechanism/names.h"

namespace desmo::cli {
namespace {

constexpr std::size_t line_width = 100;

}  // namespace

std::string count(long n, const std::string& noun, const std::string& plural) {
  return std::to_string(n) + " " + (n == 1 ? noun : plural.empty() ? noun + "s" : plural);
}

std::string enumerate(const std::vector<std::string>& names, std::size_t most) {
  std::string text = joined(names | std::views::take(most));
  if (names.size() > most) text += ", … (" + std::to_string(names.size() - most) + " more)";
  return text;
}

std::string named_group(const Group& group) {
  return "group '" + group.name + "' (" + enumerate(group.bodies, 8) + ")";
}

std::string in_group(GroupId group, const Model& m) {
  return group < 0 ? "" : named_group(m.groups[group]) + ", ";
}

std::string time_text(double time) { return formatted("t = %.9g s", time); }

std::string time_range_text(double from, double to) {
  const std::string first = formatted("%.12g s", from), last = formatted("%.12g s", to);
  return "t = " + (first == last ? first : first + " to " + last);
}

std::vector<std::string> driver_names(const Model& m) {
  std::vector<std::string> names;
  for (const Driver& d : m.drivers) names.push_back(m.entities[d.coordinate].name);
  return names;
}

std::string wrap(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string result;
  std::size_t column = 0;
  for (std::string word; words >> word;) {
    if (column > 0 && column + 1 + characters(word) > line_width - indent) {
      result += "\n" + std::string(indent, ' ');
      column = 0;
    }
    result += (column > 0 ? " " : "") + word;
    column += characters(word) + (column > 0);
  }
  return result;
}

std::string table(const std::vector<std::vector<std::string>>& rows, std::string_view right) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c)
      widths[c] = std::max(widths[c], characters(row[c]));
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string space(widths[c] - characters(row[c]), ' ');
      const bool to_the_right = c < right.size() && right[c] == 'r';
      line += "  " + (to_the_right ? space + row[c] : row[c] + space);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace desmo::cli
