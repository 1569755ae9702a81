#include "cases/mechanism/names.h"

#include <algorithm>
#include <boost/locale/utf.hpp>
#include <numeric>

#include "cases/mechanism/formatted.h"

namespace desmo {
namespace {

namespace utf = boost::locale::utf;

constexpr int max_distance = 3;           // edit distance of a similar name, ≤
constexpr std::size_t min_contained = 3;  // bytes of a part by which a name is found, ≥
constexpr std::size_t max_suggestions = 3;
// A list of up to max_listed names is shown whole, of a longer one the first first_listed.
constexpr std::size_t max_listed = 15, first_listed = 8;

// Returns Levenshtein's distance of two texts in bytes, or limit + 1 when it is larger than limit.
// Evaluates only a band of 2 limit + 1 diagonals of the table, since the search for a misspelt name
// compares it with every name of a mechanism.
int edit_distance(std::string_view a, std::string_view b, int limit) {
  const int rows = static_cast<int>(a.size()), columns = static_cast<int>(b.size());
  if (std::abs(rows - columns) > limit) return limit + 1;
  std::vector<int> distance(b.size() + 1);  // [j]: of the first i bytes of a and j bytes of b
  std::iota(distance.begin(), distance.end(), 0);
  for (int i = 1; i <= rows; ++i) {
    const int first = std::max(1, i - limit), last = std::min(columns, i + limit);
    int diagonal = distance[first - 1];
    distance[first - 1] = first == 1 ? i : limit + 1;
    for (int j = first; j <= last; ++j) {
      const int replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = distance[j];
      distance[j] = std::min({replaced, distance[j] + 1, distance[j - 1] + 1});
    }
  }
  return std::min(distance[columns], limit + 1);
}

// Returns whether a character is a control character, shows nothing, or reverses the direction of
// writing.
bool misleads(char32_t c) {
  const auto in = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
  return c < 0x20 || in(0x7f, 0x9f) || c == 0xad || c == 0x61c || in(0x200b, 0x200f) ||
         in(0x2028, 0x202e) || in(0x2060, 0x206f) || c == 0xfeff || in(0xfff9, 0xfffb) ||
         in(0xe0000, 0xe0fff);
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_./- ").find(c) != std::string_view::npos;
}

// Returns whether a character misleads or is a blank beyond ASCII, which looks like ASCII's blank.
bool shows_nothing(char32_t c) {
  return misleads(c) || c == 0xa0 || c == 0x1680 || (c >= 0x2000 && c <= 0x200a) || c == 0x202f ||
         c == 0x205f || c == 0x3000;
}

// Calls found(character, its bytes) for each character until found() returns true. Bytes that are
// no UTF-8 come one by one as utf::illegal. Returns whether found() has returned true.
template <class F>
bool for_each_character(std::string_view text, F found) {
  while (!text.empty()) {
    const char* next = text.data();
    const utf::code_point c = utf::utf_traits<char>::decode(next, text.data() + text.size());
    const bool is_valid = utf::is_valid_codepoint(c);
    const std::size_t bytes = is_valid ? next - text.data() : 1;
    if (found(is_valid ? c : utf::illegal, text.substr(0, bytes))) return true;
    text.remove_prefix(bytes);
  }
  return false;
}

}  // namespace

bool is_name(std::string_view text) {
  if (text.empty() || characters(text) > max_name) return false;
  if (text.front() == '-' || text.front() == ' ' || text.back() == ' ') return false;
  if (text.starts_with("d/dt ") || text.starts_with("d2/dt2 ")) return false;  // names of rates
  return !for_each_character(text, [](utf::code_point c, std::string_view bytes) {
    return c == utf::illegal || (c < 0x80 ? !is_plain(bytes.front()) : shows_nothing(c));
  });
}

bool matches(std::string_view pattern, std::string_view name) {
  std::size_t p = 0, n = 0;
  // Position of the last * in the pattern, and of the first character of the name after its match.
  std::size_t star = std::string_view::npos, resume = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p, ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++resume;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::vector<std::string_view> nearest_names(std::string_view name,
                                            std::span<const std::string_view> known) {
  if (name.size() > max_name) return {};
  const int limit = std::clamp(static_cast<int>(name.size()) / 2, 1, max_distance);
  std::vector<std::pair<int, std::string_view>> near;
  for (const std::string_view candidate : known) {
    const int distance = edit_distance(name, candidate, limit);
    // A name of one letter resembles no other such name.
    const int longest = static_cast<int>(std::max(name.size(), candidate.size()));
    if (distance <= limit && distance < longest) near.emplace_back(distance, candidate);
  }
  if (near.empty() && name.size() >= min_contained)
    for (const std::string_view candidate : known)
      if (candidate.find(name) != candidate.npos) near.emplace_back(0, candidate);
  std::ranges::stable_sort(near, {}, &std::pair<int, std::string_view>::first);
  if (near.size() > max_suggestions) near.resize(max_suggestions);
  std::vector<std::string_view> names;
  for (const auto& [distance, candidate] : near) names.push_back(candidate);
  return names;
}

std::string enumeration(std::span<const std::string_view> known) {
  if (known.empty()) return "there are none";
  if (known.size() <= max_listed) return "there are " + joined(known, in_quotes);
  return "there are " + std::to_string(known.size()) + ", the first are " +
         joined(known.first(first_listed), in_quotes);
}

std::string suggestion(std::string_view name, std::span<const std::string_view> known) {
  const std::vector<std::string_view> near = nearest_names(name, known);
  return near.empty() ? enumeration(known) : "did you mean " + joined(near, in_quotes) + "?";
}

std::string unknown_name(const std::string& kind, std::string_view name,
                         std::span<const std::string_view> known) {
  return "unknown " + kind + " " + in_quotes(name) + "; " + suggestion(name, known);
}

std::string printable(std::string_view text, std::size_t limit) {
  std::string shown;
  std::size_t characters = 0;
  for_each_character(text, [&](utf::code_point c, std::string_view bytes) {
    if (characters++ == limit) {
      shown += "...";
      return true;
    }
    if (c == utf::illegal)
      shown += formatted("\\x%02x", static_cast<unsigned char>(bytes.front()));
    else if (misleads(c))
      shown += formatted("\\u%04x", static_cast<unsigned>(c));
    else
      shown += bytes;
    return false;
  });
  return shown;
}

std::size_t characters(std::string_view text) {
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  return static_cast<std::size_t>(std::ranges::count_if(text, begins));
}

std::string in_quotes(std::string_view text) { return "'" + printable(text) + "'"; }

}  // namespace desmo
