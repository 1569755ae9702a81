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

/// Returns the words of an identifier in lower case: takeRooms2, take_rooms_ → "_take_rooms_".
std::string words_of(const std::string& identifier) {
  std::string words = "_";
  unsigned char before = '_';
  for (const unsigned char c : identifier) {
    const bool is_first = std::isupper(c) && std::islower(before);
    if (words.back() != '_' && (is_first || !std::isalpha(c))) words += '_';
    if (std::isalpha(c)) words += static_cast<char>(std::tolower(c));
    before = c;
  }
  return words.back() == '_' ? words : words + '_';
}

struct Entry {
  std::string kind, word, instead;

  bool holds_of(const std::string& identifier, const std::string& words) const {
    if (kind == "whole") return identifier == word;
    const std::string sought = words_of(word);
    if (kind == "first") return words.starts_with(sought) && words != sought;
    return words.find(sought) != words.npos;
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
    if (!word.empty() && (word.front() < '0' || word.front() > '9')) found.insert(word);
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
  EXPECT_EQ(words_of("RoomPool2::x"), "_room_pool_x_");
  EXPECT_EQ(words_of("take_rooms_"), "_take_rooms_");
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
        const std::string words = words_of(identifier);
        for (const Entry& entry : list)
          EXPECT_FALSE(entry.holds_of(identifier, words))
              << fs::relative(file.path(), source_dir) << ": " << identifier << " has "
              << entry.word << "; say " << entry.instead;
      }
    }
}

}  // namespace
}  // namespace desmo::vocabulary_test
