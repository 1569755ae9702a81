#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "tests/fuzz/mutations.h"

namespace desmo::fuzz {
namespace {

struct Span {
  std::size_t begin, size;
};

/// Returns words, texts in quotes and single marks, also of text that is no longer JSON.
std::vector<Span> tokens(std::string_view text) {
  constexpr std::string_view space = " \t\r\n", marks = "{}[],:";
  std::vector<Span> all;
  for (std::size_t at = 0; (at = text.find_first_not_of(space, at)) != text.npos;) {
    std::size_t end = at + 1;
    if (text[at] == '"')
      end = std::min(text.find('"', at + 1), text.size() - 1) + 1;
    else if (marks.find(text[at]) == marks.npos)
      end = std::min(text.find_first_of(" \t\r\n{}[],:\"", at), text.size());
    all.push_back({at, end - at});
    at = end;
  }
  return all;
}

Span any_token(std::string_view text, Random& random) {
  const std::vector<Span> all = tokens(text);
  return random.pick(all);
}

/// Returns a line with its end: a member, of most; or a token, or some bytes.
Span any_span(std::string_view text, Random& random) {
  if (random.one_in(2)) return any_token(text, random);
  std::size_t begin = random.below(text.size() + 1),
              size = random.below(random.one_in(8) ? 200 : 5);
  if (random.one_in(4)) {
    begin = text.rfind('\n', begin) + 1;  // the first line where there is no '\n'
    size = text.find('\n', begin) - begin + 1;
  }
  return {begin, std::min(size, text.size() - begin)};
}

std::string nested(const std::string& inner, Random& random) {
  std::string open, close;
  for (std::size_t depth = random.below(random.one_in(8) ? 20'000 : 40); depth > 0; --depth) {
    const bool is_list = random.one_in(2);
    open += is_list ? "[" : "{\"a\":";
    close += is_list ? ']' : '}';
  }
  std::ranges::reverse(close);
  return open + inner + (random.one_in(2) ? close : "");
}

std::string lengthened(std::string token, Random& random) {
  const std::size_t length = random.one_in(4) ? random.below(100'000) : 90 + random.below(130);
  const char letter = "aA_*\xc3~/"[random.below(7)];
  return token.insert(std::min<std::size_t>(1, token.size()), length, letter);
}

std::string repeated(const std::string& piece, Random& random) {
  std::string text = piece;
  for (std::size_t times = 1 + random.below(random.one_in(16) ? 100 : 3); times > 0; --times)
    text += piece;
  return text;
}

std::string damaged(std::string piece, Random& random) {
  if (!piece.empty()) {
    char& byte = piece[random.below(piece.size())];
    byte = static_cast<char>(random.one_in(2) ? byte ^ (1 << random.below(8)) : random.bits());
  }
  return piece;
}

/// Writes an entity's name, or what else it is, otherwise wherever it stands.
void replace_everywhere(std::string& text, Random& random) {
  const Span from = any_token(text, random), to = any_token(text, random);
  const std::string old = text.substr(from.begin, from.size);
  const std::string by = random.one_in(3) ? lengthened(old, random).substr(0, 100 + random.below(4))
                                          : text.substr(to.begin, to.size);
  std::string result;
  std::size_t done = 0;
  for (const Span& token : tokens(text)) {
    if (text.compare(token.begin, token.size, old) != 0) continue;
    result += text.substr(done, token.begin - done) + by;
    done = token.begin + token.size;
  }
  text = result + text.substr(done);
}

}  // namespace

void spoil_text(std::string& text, const Grammar& grammar, Random& random) {
  static constexpr std::array<std::string_view, 3> no_utf8 = {"\xff", "\xc0\x80", "\xed\xa0\x80"};
  const Span at = any_span(text, random), other = any_span(text, random);
  const std::string old = text.substr(at.begin, at.size);
  const auto replace = [&](const std::string& by) { text.replace(at.begin, at.size, by); };
  switch (random.below(11)) {
    case 0:
      return text.resize(at.begin);
    case 1:
      return replace("");
    case 2:
      return replace(damaged(old, random));
    case 3:
      return replace(repeated(old, random));
    case 4:
      return replace(text.substr(other.begin, other.size));
    case 5:
      return replace(grammar.spelling("extreme", random));
    case 6:
      return replace(old + grammar.spelling("oddity", random));
    case 7:
      return replace(old + std::string(random.pick(no_utf8)));
    case 8:
      return replace(nested(old, random));
    case 9:
      return replace(lengthened(old, random));
    default:
      return replace_everywhere(text, random);
  }
}

}  // namespace desmo::fuzz
