// Names: the nearest ones, patterns, and how they are shown.

#include "cases/mechanism/names.h"

#include <gtest/gtest.h>

namespace desmo::names_test {
namespace {

TEST(Names, NearestComeFirstAndInOrder) {
  using Names = std::vector<std::string_view>;
  const Names known{"C2", "rod", "C", "theta", "D"};
  EXPECT_EQ(nearest_names("C1", known), (Names{"C2", "C"}));
  EXPECT_EQ(nearest_names("tehta", known), (Names{"theta"}));
  EXPECT_EQ(nearest_names("something", known), Names{});
  EXPECT_EQ(nearest_names("X1", Names{"A1", "B1", "C1", "D1"}), (Names{"A1", "B1", "C1"}));
  EXPECT_EQ(nearest_names("X", Names{"A", "X2", "B"}), (Names{"X2"}));
  const Names ids{"global_lapack", "group_explicit", "block_explicit"};
  EXPECT_EQ(nearest_names("explicit", ids), (Names{"group_explicit", "block_explicit"}));
  EXPECT_EQ(nearest_names("explict", Names{"group_explict", "explicit"}), (Names{"explicit"}));
  EXPECT_EQ(nearest_names("loc", ids), (Names{"block_explicit"}));
  EXPECT_EQ(nearest_names("lo", ids), Names{}) << "too short to say anything";
  EXPECT_EQ(suggestion("C1", known), "did you mean 'C2', 'C'?");
  EXPECT_EQ(suggestion("something", Names{}), "there are none");
  EXPECT_NE(enumeration(Names(15, "x")).find("there are 'x'"), std::string::npos);
  EXPECT_NE(enumeration(Names(16, "x")).find("there are 16, the first are"), std::string::npos);
}

TEST(Names, PatternsMatchAnyCharacters) {
  EXPECT_TRUE(matches("*", ""));
  EXPECT_TRUE(matches("axle*/S", "axle12/S"));
  EXPECT_TRUE(matches("*a*b*", "xxaxxbxx"));
  EXPECT_TRUE(matches("a**", "a"));
  EXPECT_FALSE(matches("axle*/S", "axle12/St"));
  EXPECT_FALSE(matches("", "a"));
  EXPECT_FALSE(matches(std::string(50, '*') + "b", std::string(100, 'a')));
}

TEST(Names, HaveBlanksAndLettersOfAnyLanguage) {
  for (const char* name : {"a", "_", "Größe 2", "a b  c", "κ/角", ".x-"})
    EXPECT_TRUE(is_name(name)) << name;
  for (const char* name : {"", " a", "a ", "-a", "a*", "a\tb", "a\u00a0b", "a\u3000b", "a\u200bb",
                           "\xff", "a\xc3", "a,b", "a[", "d/dt a", "d2/dt2 a"})
    EXPECT_FALSE(is_name(name)) << name;
  std::string longest;
  for (std::size_t i = 0; i < max_name; ++i) longest += "ü";
  EXPECT_TRUE(is_name(longest));
  EXPECT_FALSE(is_name(longest + "x"));
  EXPECT_TRUE(matches("Gr*e ?*", "Größe ?x"));
  EXPECT_TRUE(matches("*ö*", "Größe"));
}

TEST(Names, AreShownSafely) {
  EXPECT_EQ(printable("größe"), "größe");
  EXPECT_EQ(printable("a\x1b[0m\n"), "a\\u001b[0m\\u000a");
  EXPECT_EQ(printable("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(printable("\u202egpj"), "\\u202egpj");
  EXPECT_EQ(printable("ää", 1), "ä...");
}

}  // namespace
}  // namespace desmo::names_test
