#include "report/text/texts.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "report/text/embedded.h"

namespace desmo::report {
namespace {

using TextLines = std::vector<std::pair<std::string, std::string>>;  // words of a block, and texts
using TextBlocks = std::map<std::string, TextLines, std::less<>>;

TextBlocks parse_texts(std::string_view file) {
  TextBlocks blocks;
  TextLines* block = nullptr;
  std::istringstream lines{std::string(file)};
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    if (line.starts_with('[')) {
      block = &blocks[line.substr(1, line.size() - 2)];
    } else if (line.starts_with("  ")) {
      block->back().second += line.substr(1);
    } else {
      const std::size_t sign = line.find(" = ");
      block->emplace_back(line.substr(0, sign),
                          sign == line.npos ? std::string() : line.substr(sign + 3));
    }
  }
  return blocks;
}

const TextLines& block_named(std::string_view name) {
  static const TextBlocks blocks = parse_texts(embedded_file("texts.txt"));
  const auto found = blocks.find(name);
  if (found == blocks.end()) throw std::logic_error("no texts of " + std::string(name));
  return found->second;
}

/// Reads a column: "µs/step: microseconds again" has the heading µs/step and the quantities
/// microseconds and again.
Column parse_column(const std::string& text) {
  const std::size_t colon = text.find(": ");
  Column column{text.substr(0, colon), {}};
  if (colon == text.npos) return column;
  std::istringstream words(text.substr(colon + 2));
  for (std::string word; words >> word;) column.quantities.push_back(word);
  return column;
}

}  // namespace

std::string filled(std::string_view text, const TextValues& values) {
  std::string result;
  while (true) {
    const std::size_t begin = text.find('{'), end = text.find('}', std::min(begin, text.size()));
    result += text.substr(0, begin);
    if (begin == text.npos) return result;
    const std::string_view name = text.substr(begin + 1, end - begin - 1);
    const auto value = std::ranges::find(values, name, &TextValue::name);
    result += value != values.end() ? value->text : sentence(name, values);
    text.remove_prefix(end + 1);
  }
}

std::string sentence(std::string_view name, const TextValues& values) {
  const std::size_t dot = name.find('.');
  if (dot == name.npos) throw std::logic_error("no value of " + std::string(name));
  for (const auto& [word, text] : block_named(name.substr(0, dot)))
    if (word == name.substr(dot + 1)) return filled(text, values);
  throw std::logic_error("no text " + std::string(name));
}

std::string in_a_row(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
  return text;
}

Table headed_table(std::string_view block, const TextValues& values) {
  Table table{.name = std::string(block)};
  for (const auto& [word, text] : block_named(block)) {
    if (word == "name") table.name = filled(text, values);
    if (word == "title") table.title = filled(text, values);
    if (word == "note")
      if (std::string note = filled(text, values); !note.empty())
        table.notes.push_back(std::move(note));
    if (word == "caption") table.caption = filled(text, values);
    if (word == "column") table.columns.push_back(parse_column(filled(text, values)));
    if (word == "detail") table.detail = true;
    if (word == "drawn") table.drawn = text;
    if (word == "figure") table.figure = text.empty() ? std::string(block) : text;
  }
  return table;
}

Section headed_section(std::string_view block, const TextValues& values,
                       std::vector<Table> tables) {
  Section section{.tables = std::move(tables)};
  for (const auto& [word, text] : block_named(block)) {
    if (word == "title") section.title = filled(text, values);
    if (word == "paragraph") section.paragraphs.push_back(filled(text, values));
    if (word == "definition") section.definitions.push_back(filled(text, values));
    if (word == "number") section.numbers.push_back(filled(text, values));
  }
  return section;
}

}  // namespace desmo::report
