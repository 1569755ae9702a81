// Identifiers of the production code use the field's words: none of those that vocabulary.txt
// lists.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/started.h"

namespace desmo::vocabulary_test {
namespace {

namespace fs = std::filesystem;

const fs::path source_dir = DESMO_SOURCE_DIR;

using Words = std::vector<std::string>;

/// Returns the components of an identifier in lower case: takeRooms2, take_rooms_ → take, rooms.
Words components(const std::string& identifier) {
  Words words;
  char before = '_';
  for (const char c : identifier) {
    if (std::isalpha(static_cast<unsigned char>(c))) {
      const bool starts = !std::isalpha(static_cast<unsigned char>(before)) ||
                          (std::isupper(static_cast<unsigned char>(c)) &&
                           std::islower(static_cast<unsigned char>(before)));
      if (starts) words.emplace_back();
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    before = c;
  }
  return words;
}

struct Entry {
  std::string kind, word, instead;

  bool holds_of(const std::string& identifier, const Words& words) const {
    if (kind == "whole") return identifier == word;
    if (kind == "first") return words.size() > 1 && words.front() == word;
    return !std::ranges::search(words, components(word)).empty();
  }
};

std::vector<Entry> entries() {
  std::vector<Entry> all;
  std::ifstream in(source_dir / "tests/program/vocabulary.txt");
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream fields(line);
    Entry entry;
    fields >> entry.kind >> entry.word >> std::ws;
    std::getline(fields, entry.instead);
    all.push_back(entry);
  }
  return all;
}

/// Returns the identifiers of a source text, without comments and what stands in quotes.
std::set<std::string> identifiers(const std::string& text) {
  std::set<std::string> found;
  std::string word;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : ' ';
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') {
      word += c;
      continue;
    }
    if (!word.empty() && !std::isdigit(static_cast<unsigned char>(word.front())))
      found.insert(word);
    word.clear();
    if (text.compare(i, 2, "//") == 0) {
      i = std::min(text.find('\n', i), text.size());
    } else if (c == '"') {
      for (++i; i < text.size() && text[i] != '"' && text[i] != '\n'; ++i) i += text[i] == '\\';
    }
  }
  return found;
}

TEST(Vocabulary, SplitsIdentifiersAndPassesOverTextAndComments) {
  EXPECT_EQ(components("RoomPool2::x"), (Words{"room", "pool", "x"}));
  EXPECT_EQ(components("take_rooms_"), (Words{"take", "rooms"}));
  EXPECT_EQ(identifiers("a = b1; // c\nf(\"d \\\" e\", 2);"),
            (std::set<std::string>{"a", "b1", "f"}));
}

TEST(Vocabulary, NoIdentifierHasAWordOfTheList) {
  const std::vector<Entry> list = entries();
  ASSERT_GT(list.size(), 40u);
  for (const char* top : {"cases", "formulations", "bench", "report"})
    for (const auto& file : fs::recursive_directory_iterator(source_dir / top)) {
      const std::string extension = file.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      for (const std::string& identifier : identifiers(text_of(file.path()))) {
        const Words words = components(identifier);
        for (const Entry& entry : list)
          EXPECT_FALSE(entry.holds_of(identifier, words))
              << fs::relative(file.path(), source_dir) << ": " << identifier << " has "
              << entry.word << "; say " << entry.instead;
      }
    }
}

}  // namespace
}  // namespace desmo::vocabulary_test
