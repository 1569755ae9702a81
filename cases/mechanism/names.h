#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace desmo {

/// The longest name that a file may give, in characters.
constexpr std::size_t max_name = 100;

/// Whether a text consists of letters, digits and `_ . / -` only, does not begin with `-`, and is
/// neither empty nor longer than `max_name`.
bool is_name(std::string_view text);

/// What a pattern matches: `*` stands for any characters, also none.
bool matches(std::string_view pattern, std::string_view name);

/// Of the known names at most three that differ from `name` in few letters (edit distance at most
/// 3 and half its length), nearest first, equally near ones in the order given.
std::vector<std::string_view> nearest_names(std::string_view name,
                                            std::span<const std::string_view> known);

/// "there are 'C', 'D'"; of many the number and the first.
std::string enumeration(std::span<const std::string_view> known);

/// The end of a message about a name that is not known: "did you mean 'C', 'C2'?", or the
/// enumeration when nothing is near.
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

/// A text from outside, fit for a terminal: control characters, invisible ones and what is not
/// UTF-8 are escaped; at most `limit` characters are shown.
std::string printable(std::string_view text, std::size_t limit = 60);

/// printable, between single quotes.
std::string in_quotes(std::string_view text);

}  // namespace desmo
