#include "report/read/record_value.h"

#include <algorithm>
#include <cmath>

#include "report/text/digits.h"

namespace desmo::report {
namespace {

constexpr int max_integer = 1'000'000'000;
constexpr double max_count = 1e15;  // below 2^53: each whole number is a double
constexpr double min_sample = 1e-9;
constexpr double max_sample = 1e9;

bool has_only(std::string_view text, std::string_view characters) {
  return text.find_first_not_of(characters) == text.npos;
}

}  // namespace

std::string beginning_of(std::string_view text) {
  constexpr int max_characters = 60;
  int characters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = (static_cast<unsigned char>(text[i]) & 0xc0) != 0x80;
    if (begins && characters++ == max_characters) return std::string(text.substr(0, i)) + "...";
  }
  return std::string(text);
}

std::string in_double_quotes(std::string_view text) { return "\"" + beginning_of(text) + "\""; }

std::string RecordValue::text() const {
  std::string text(JsonValue::text());
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return text;
}

std::string RecordValue::name() const {
  const std::string text = this->text();
  if (text.empty() ||
      !has_only(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-"))
    complain(in_double_quotes(text) + " is not a name of letters, digits, _ and -");
  return text;
}

std::string RecordValue::digest() const {
  const std::string text = this->text();
  if (text.size() != 64 || !has_only(text, "0123456789abcdef"))
    complain(in_double_quotes(text) + " is not a SHA-256 digest");
  return text;
}

std::string RecordValue::utc() const {
  const std::string text = this->text();
  constexpr std::string_view form = "0000-00-00T00:00:00Z";
  const bool formed = std::ranges::equal(text, form, [](char c, char place) {
    return place == '0' ? '0' <= c && c <= '9' : c == place;
  });
  if (!formed || text.substr(5, 2) > "12" || text.substr(8, 2) > "31" || text.substr(11, 2) > "23")
    complain(in_double_quotes(text) + " is not a date and time, UTC, as 2026-11-21T17:48:47Z");
  return text;
}

std::int64_t RecordValue::integer(int least) const { return whole_number(least, max_integer); }

std::int64_t RecordValue::count() const {
  const double value = number();
  if (!(value >= 1 && value <= max_count) || value != std::floor(value))
    complain("a whole number from 1 to 1e15 was expected");
  return static_cast<std::int64_t>(value);
}

double RecordValue::not_negative() const {
  const double value = number();
  if (!(value >= 0)) complain("is negative");
  return value;
}

double RecordValue::positive() const {
  const double value = not_negative();
  if (!(value > 0)) complain("is not above zero");
  return value;
}

double RecordValue::sample() const {
  const double value = positive();
  if (value < min_sample || value > max_sample) complain("is not a time that a clock can give");
  return value;
}

std::vector<std::pair<std::string, std::string>> RecordValue::leaves() const {
  if (is_string()) return {{"", text()}};
  if (is_number()) return {{"", write_shortest(number())}};
  std::vector<std::pair<std::string, std::string>> all;
  if (is_array()) {
    std::string list;
    for (const RecordValue element : elements())
      for (const auto& [name, text] : element.leaves()) list += (list.empty() ? "" : ", ") + text;
    return {{"", list}};
  }
  if (!is_object()) return {{"", boolean() ? "yes" : "no"}};
  for (const RecordValue member : members())
    for (const auto& [name, text] : member.leaves())
      all.emplace_back(std::string(member.key()) + (name.empty() ? "" : " " + name), text);
  return all;
}

std::size_t RecordValue::one_of(std::initializer_list<std::string_view> words) const {
  const std::string text = this->text();
  const auto found = std::ranges::find(words, text);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string list;
  for (const std::string_view word : words)
    list += (list.empty() ? "" : ", ") + in_double_quotes(word);
  complain(in_double_quotes(text) + " is none of " + list);
}

}  // namespace desmo::report
