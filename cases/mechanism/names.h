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

/// Returns whether a text is a name: 1 to `max_name` visible characters beyond ASCII, or ASCII
/// letters, digits, blanks and `_ . / -`, not beginning with `-` or a blank nor ending with one.
/// Columns of rates begin with `d/dt `, names do not.
bool is_name(std::string_view text);

/// Returns whether a name matches a pattern, in which `*` stands for any number of characters.
bool matches(std::string_view pattern, std::string_view name);

/// Returns the entries of a list one after the other; `text`: what is shown of an entry.
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

/// Returns at most three known names similar to `name`: edit distance at most 3 and half its
/// length. Nearest names come first, equally near ones in the order given. Where none is similar,
/// returns names that contain `name`, if it has at least 3 characters.
std::vector<std::string_view> nearest_names(std::string_view name,
                                            std::span<const std::string_view> known);

/// Returns "there are 'C', 'D'"; of a long list the number and the first names.
std::string enumeration(std::span<const std::string_view> known);

/// Returns the end of a message about an unknown name: "did you mean 'C', 'C2'?", or the
/// enumeration when nothing is similar.
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

/// Returns "unknown <kind> 'B'; " and the suggestion.
std::string unknown_name(const std::string& kind, std::string_view name,
                         std::span<const std::string_view> known);

/// Returns the names of a table's entries, in its order; the entries must outlive them.
template <class Table>
std::vector<std::string_view> names_of(const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& entry : table) names.push_back(entry.name);
  return names;
}

/// Returns the entry of a table that has that name. Throws std::invalid_argument, which says that
/// it is unknown, when there is none.
template <class Table>
const auto& entry_named(std::string_view name, const Table& table, const std::string& kind) {
  for (const auto& entry : table)
    if (entry.name == name) return entry;
  throw std::invalid_argument(unknown_name(kind, name, names_of(table)));
}

/// Returns an external text in a form that is safe on terminals, at most `limit` characters of it.
/// Control and invisible characters and invalid UTF-8 are escaped.
std::string printable(std::string_view text, std::size_t limit = 60);

/// Returns the number of a text's characters, which in UTF-8 may have several bytes.
std::size_t characters(std::string_view text);

/// Returns printable(text) in single quotes.
std::string in_quotes(std::string_view text);

}  // namespace desmo
