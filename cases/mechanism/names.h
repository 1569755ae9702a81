#pragma once

#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace desmo {

/// Maximum length of a name in a file, in characters.
constexpr std::size_t max_name = 100;

/// Returns whether a text is a name: 1 to `max_name` characters, each a visible one beyond ASCII,
/// an ASCII letter, a digit, a blank or one of `_ . / -`. It does not begin with `-` or a blank,
/// nor end with a blank, nor begin with `d/dt ` or `d2/dt2 `, as columns of rates do.
bool is_name(std::string_view text);

/// Returns whether a whole name matches a pattern, in which `*` stands for zero or more characters.
bool matches(std::string_view pattern, std::string_view name);

/// Returns the texts of a list's entries with `between` between them. text: function or member that
/// gives the text of an entry; without it the entry itself.
template <class List, class Text = std::identity>
std::string joined(List&& list, Text text = {}, std::string_view between = ", ") {
  std::string all;
  bool is_first = true;
  for (const auto& entry : list) {
    if (!std::exchange(is_first, false)) all += between;
    all += std::invoke(text, entry);
  }
  return all;
}

/// Returns at most three known names similar to `name`. Their edit distance, in bytes, is at most 3
/// and at most half the length of `name`, or 1 where that half is 0; names of one byte are never
/// similar. Nearest names come first, equally near ones in the order given. Where none is similar,
/// returns names that contain `name`, if it has at least 3 bytes. Returns none where it has more
/// than max_name bytes.
std::vector<std::string_view> nearest_names(std::string_view name,
                                            std::span<const std::string_view> known);

/// Returns "there are 'C', 'D'"; of more than 15 names their number and the first 8; of none "there
/// are none".
std::string enumeration(std::span<const std::string_view> known);

/// Returns the end of a message about an unknown name: "did you mean 'C', 'C2'?", or enumeration()
/// when no known name is similar.
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

/// Returns "unknown <kind> 'B'; " and the suggestion.
std::string unknown_name(const std::string& kind, std::string_view name,
                         std::span<const std::string_view> known);

/// Returns the names of a table's entries, in its order. The entries must outlive the result.
template <class Table>
std::vector<std::string_view> names_of(const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& entry : table) names.push_back(entry.name);
  return names;
}

/// Returns the first entry of a table that has that name. Throws std::invalid_argument with
/// unknown_name() when there is none.
template <class Table>
const auto& entry_named(std::string_view name, const Table& table, const std::string& kind) {
  for (const auto& entry : table)
    if (entry.name == name) return entry;
  throw std::invalid_argument(unknown_name(kind, name, names_of(table)));
}

/// Returns the first `limit` characters of an external text in a form that is safe on terminals,
/// then "..." if it has more. Control and invisible characters and invalid UTF-8 are escaped.
std::string printable(std::string_view text, std::size_t limit = 60);

/// Returns the number of characters of a text in UTF-8, where one may have several bytes.
std::size_t characters(std::string_view text);

/// Returns printable(text) in single quotes.
std::string in_quotes(std::string_view text);

}  // namespace desmo
