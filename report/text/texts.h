// The words of the report in text/texts.txt: sentences with placeholders, and the heads of tables
// and sections.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

#include "report/text/document.h"

namespace desmo::report {

/// A value for the placeholder {name} of a text.
struct TextValue {
  TextValue(std::string_view name, std::string_view text) : name(name), text(text) {}
  TextValue(std::string_view name, std::integral auto number)
      : name(name), text(std::to_string(number)) {}

  std::string_view name;
  std::string text;
};

using TextValues = std::vector<TextValue>;

/// Returns words as a list in a sentence: "15, 25 and 66".
std::string in_a_row(const std::vector<std::string>& words);

// The functions below throw std::logic_error when the file has no such text, or a placeholder has
// no value.

/// Returns a text in which each placeholder {name} is replaced by the value of that name, and
/// {block.word} by that sentence.
std::string filled(std::string_view text, const TextValues& values);

/// Returns the sentence "block.word" with its placeholders filled.
std::string sentence(std::string_view name, const TextValues& values = {});

/// Returns a table without rows. Sets what a block says: name (without one, that of the block),
/// title, columns, notes, whether it is a detail; and of its figure design, caption and the column
/// of its marks (`drawn`). Leaves out notes that are empty once placeholders are filled.
Table headed_table(std::string_view block, const TextValues& values = {});

/// Returns a section that has the tables, and the title, paragraphs, definitions and numbers of a
/// block.
Section headed_section(std::string_view block, const TextValues& values = {},
                       std::vector<Table> tables = {});

}  // namespace desmo::report
