#include <algorithm>
#include <array>
#include <string>

#include "tests/fuzz/mutations.h"

namespace desmo::fuzz {
namespace {

struct Token {
  std::size_t begin, length;
};

// Words, texts in quotes and single marks, by the same rules for text that is no longer JSON.
std::vector<Token> tokens(std::string_view text) {
  constexpr std::string_view space = " \t\r\n", marks = "{}[],:";
  std::vector<Token> all;
  for (std::size_t at = 0; at < text.size();) {
    if (space.find(text[at]) != space.npos) {
      ++at;
      continue;
    }
    std::size_t end = at + 1;
    if (text[at] == '"') {
      end = text.find('"', at + 1);
      end = end == text.npos ? text.size() : end + 1;
    } else if (marks.find(text[at]) == marks.npos) {
      end = std::min(text.find_first_of(" \t\r\n{}[],:\"", at), text.size());
    }
    all.push_back({at, end - at});
    at = end;
  }
  return all;
}

void replace_token(std::string& text, Random& random, std::string_view by) {
  const std::vector<Token> all = tokens(text);
  if (all.empty()) return;
  const Token& token = random.pick(all);
  text.replace(token.begin, token.length, by);
}

void flip_bit(std::string& text, Random& random) {
  if (!text.empty()) text[random.below(text.size())] ^= static_cast<char>(1 << random.below(8));
}

void set_byte(std::string& text, Random& random) {
  if (!text.empty()) text[random.below(text.size())] = static_cast<char>(random.next());
}

void remove_bytes(std::string& text, Random& random) {
  text.erase(random.below(text.size() + 1), 1 + random.below(random.one_in(8) ? 200 : 4));
}

void repeat_bytes(std::string& text, Random& random) {
  const std::size_t at = random.below(text.size() + 1);
  const std::string piece = text.substr(at, 1 + random.below(random.one_in(4) ? 200 : 4));
  for (std::size_t times = 1 + random.below(random.one_in(16) ? 100 : 3); times > 0; --times)
    text.insert(at, piece);
}

void truncate(std::string& text, Random& random) { text.resize(random.below(text.size() + 1)); }

void copy_bytes(std::string& text, Random& random) {
  const std::string piece = text.substr(random.below(text.size() + 1), random.below(60));
  text.insert(random.below(text.size() + 1), piece);
}

void swap_tokens(std::string& text, Random& random) {
  const std::vector<Token> all = tokens(text);
  if (all.size() < 2) return;
  Token a = random.pick(all), b = random.pick(all);
  if (a.begin > b.begin) std::swap(a, b);
  if (a.begin == b.begin) return;
  const std::string first = text.substr(a.begin, a.length);
  const std::string second = text.substr(b.begin, b.length);
  text.replace(b.begin, b.length, first);
  text.replace(a.begin, a.length, second);
}

void copy_token(std::string& text, Random& random) {
  const std::vector<Token> all = tokens(text);
  if (all.empty()) return;
  const Token& from = random.pick(all);
  replace_token(text, random, text.substr(from.begin, from.length));
}

void remove_token(std::string& text, Random& random) { replace_token(text, random, ""); }

void spoil_number(std::string& text, Random& random) {
  std::vector<Token> numbers = tokens(text);
  std::erase_if(numbers, [&](const Token& t) {
    return text[t.begin] != '-' && (text[t.begin] < '0' || text[t.begin] > '9');
  });
  if (numbers.empty()) return;
  const Token& token = random.pick(numbers);
  text.replace(token.begin, token.length, extreme_number(random));
}

void insert_oddity(std::string& text, Random& random) {
  using namespace std::string_view_literals;
  static constexpr std::array oddities = {"\0"sv,
                                          "\x1b[31m"sv,
                                          "\\u001b"sv,
                                          "\\u0000"sv,
                                          "\\ud800"sv,
                                          "\\ud83d\\ude00"sv,
                                          "\\u202e"sv,
                                          "\xff"sv,
                                          "\xc0\x80"sv,
                                          "\xed\xa0\x80"sv,
                                          "\xc2\x9b"sv,
                                          "\xef\xbb\xbf"sv,
                                          "\xe2\x80\xae"sv,
                                          "\\"sv,
                                          "\""sv,
                                          "//"sv,
                                          "/* */"sv,
                                          "\r"sv,
                                          "\n"sv,
                                          "\t"sv,
                                          "{"sv,
                                          "}"sv,
                                          "["sv,
                                          "]"sv,
                                          ","sv,
                                          ":"sv,
                                          "null"sv,
                                          "*"sv,
                                          "-"sv,
                                          "NaN"sv,
                                          "'"sv,
                                          "~"sv,
                                          "%s%n"sv};
  text.insert(random.below(text.size() + 1), random.pick(oddities));
}

void nest_deeply(std::string& text, Random& random) {
  const std::size_t depth = 1 + random.below(random.one_in(4) ? 20'000 : 40);
  std::string brackets;
  for (std::size_t i = 0; i < depth; ++i) brackets += random.one_in(2) ? "[" : "{\"a\":";
  replace_token(text, random, brackets);
}

void lengthen_text(std::string& text, Random& random) {
  std::vector<Token> texts = tokens(text);
  std::erase_if(texts, [&](const Token& t) { return text[t.begin] != '"'; });
  if (texts.empty()) return;
  const std::size_t length = random.one_in(4) ? random.below(100'000) : 90 + random.below(130);
  text.insert(random.pick(texts).begin + 1,
              std::string(length, static_cast<char>("aA_*\xc3~/"[random.below(7)])));
}

constexpr TextMutation all_text_mutations[] = {
    flip_bit,   set_byte,     remove_bytes, repeat_bytes,  truncate,    copy_bytes,   swap_tokens,
    copy_token, remove_token, spoil_number, insert_oddity, nest_deeply, lengthen_text};

}  // namespace

std::string_view extreme_number(Random& random) {
  static const std::string long_integer = "1" + std::string(400, '0');
  static const std::string long_fraction = "0." + std::string(400, '0') + "1";
  static const std::array<std::string_view, 50> numbers = {"0",
                                                           "-0.0",
                                                           "-1",
                                                           "1",
                                                           "2",
                                                           "3",
                                                           "0.5",
                                                           "-0.5",
                                                           "100",
                                                           "1e-3",
                                                           "1e-6",
                                                           "1e-7",
                                                           "1e-8",
                                                           "1e-9",
                                                           "1e-10",
                                                           "1e-12",
                                                           "1e-13",
                                                           "1e-16",
                                                           "1e-30",
                                                           "1e-100",
                                                           "1e-160",
                                                           "1e-308",
                                                           "5e-324",
                                                           "1e3",
                                                           "1e6",
                                                           "1e9",
                                                           "1e16",
                                                           "1e30",
                                                           "1e50",
                                                           "1e77",
                                                           "1e99",
                                                           "1e100",
                                                           "1.0000001e100",
                                                           "1e154",
                                                           "1e308",
                                                           "-1e308",
                                                           "1e999",
                                                           "-1e999",
                                                           "NaN",
                                                           "Infinity",
                                                           "-Infinity",
                                                           "2147483648",
                                                           "-2147483649",
                                                           "9223372036854775808",
                                                           "18446744073709551616",
                                                           "3.141592653589793",
                                                           "1.5707963267948966",
                                                           "01",
                                                           long_integer,
                                                           long_fraction};
  return random.pick(numbers);
}

std::span<const TextMutation> text_mutations() { return all_text_mutations; }

}  // namespace desmo::fuzz
