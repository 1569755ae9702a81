#include "tests/report/formats/reading.h"

#include <charconv>
#include <sstream>
#include <utility>

namespace desmo::report {
namespace {

using Replacements = std::vector<std::pair<std::string, std::string>>;

// At each place the first that fits.
std::string replaced(const std::string& text, const Replacements& replacements) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    bool found = false;
    for (const auto& [from, to] : replacements)
      if (!found && text.compare(at, from.size(), from) == 0) {
        result += to;
        at += from.size();
        found = true;
      }
    if (!found) result += text[at++];
  }
  return result;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \n"), end = text.find_last_not_of(" \n");
  return begin == std::string::npos ? "" : text.substr(begin, end + 1 - begin);
}

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t at; (at = text.find(separator, begin)) != std::string::npos;
       begin = at + separator.size())
    parts.push_back(text.substr(begin, at - begin));
  parts.push_back(text.substr(begin));
  return parts;
}

std::string from_markdown(const std::string& text) {
  Replacements escapes{{"<br>", ""}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}};
  for (const char c : std::string("\\`*_|[]~$#")) escapes.push_back({{'\\', c}, {c}});
  return plain(replaced(trimmed(text), escapes));
}

std::string without_tags(const std::string& text) {
  std::string result;
  bool inside = false;
  for (const char c : text) {
    if (c == '<') inside = true;
    if (!inside) result += c;
    if (c == '>') inside = false;
  }
  return result;
}

std::string from_html(const std::string& text) {
  return plain(replaced(trimmed(without_tags(text)),
                        {{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}}));
}

// What stands between two marks, from a place on; moves the place behind it.
std::string between(const std::string& text, const std::string& begin, const std::string& end,
                    std::size_t& at) {
  const std::size_t from = text.find(begin, at);
  if (from == std::string::npos) return at = std::string::npos, "";
  const std::size_t to = text.find(end, from + begin.size());
  at = to + end.size();
  return text.substr(from + begin.size(), to - from - begin.size());
}

std::vector<ReadTable> tables_of_markdown(const std::string& text) {
  std::vector<ReadTable> tables;
  std::istringstream lines(text);
  std::string title;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("**") && line.ends_with("**")) title = line.substr(2, line.size() - 4);
    if (!line.starts_with("| ")) {
      inside = false;
      continue;
    }
    if (!inside) tables.push_back({from_markdown(title), {}});
    inside = true;
    if (line.starts_with("| ---")) continue;
    std::vector<std::string> row;
    for (const std::string& cell : split(line.substr(2, line.size() - 4), " | "))
      row.push_back(from_markdown(cell));
    tables.back().rows.push_back(row);
  }
  return tables;
}

std::vector<ReadTable> tables_of_html(const std::string& text) {
  std::vector<ReadTable> tables;
  std::size_t at = 0;
  while (true) {
    const std::string body = between(text, "<table", "</table>", at);
    if (at == std::string::npos) return tables;
    std::size_t place = 0;
    const std::string caption = between(body, "<caption", "</caption>", place);
    tables.push_back({from_html("<" + caption), {}});
    while (true) {
      const std::string row = between(body, "<tr", "</tr>", place);
      if (place == std::string::npos) break;
      tables.back().rows.emplace_back();
      for (const std::string& cell : split(row, "</t"))  // </th>, </td>
        if (const std::size_t begin = cell.find("<t"); begin != std::string::npos)
          tables.back().rows.back().push_back(from_html(cell.substr(begin)));
    }
  }
}

}  // namespace

std::string plain(std::string text) { return replaced(text, {{"−", "-"}}); }

std::vector<std::vector<std::string>> read_csv(const std::string& text) {
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

ReadReport read_markdown(const std::string& text) {
  return {tables_of_markdown(text), from_markdown(text)};
}

ReadReport read_html(const std::string& text) { return {tables_of_html(text), from_html(text)}; }

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

}  // namespace desmo::report
