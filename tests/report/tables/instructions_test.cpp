// Instructions a step: reader, tables, and history.

#include "report/figures/figures.h"
#include "tests/report/size_sample.h"

namespace desmo::report::instructions_test {
namespace {

TEST(Instructions, BeginWithTheFewest) {
  const Section front = instructions_sections(record_from(instructions_record())).at(0);
  EXPECT_EQ(
      front.paragraphs.at(0),
      "A step of truck_suspension with 558 coordinates takes 14000 instructions at the fewest, "
      "with group_symbolic_explicit/lanes:4: 100 times fewer than global_automatic_klu.");
  EXPECT_EQ(front.numbers.at(1), "100 times fewer than global_automatic_klu");
}

TEST(Instructions, WithoutAReferenceHaveNoRatio) {
  const Table bars = instructions_sections(record_from(instructions_record())).at(1).tables.at(0);
  expect_row(bars, {"group_symbolic_inlined"},
             {{"times fewer", missing_mark}, {"paper", "FBL-TP"}});
}

TEST(Instructions, ThatSayNothingAreRefused) {
  expect_refusals(instructions_record(), {{"/instructions/counts/0/instructions_per_step", 0, ": "},
                                          {"/instructions/counts/1/id", "global_automatic_klu",
                                           "/instructions/counts/1: "}});
}

TEST(History, NamesTheCommitsInWhichACandidateMoved) {
  const Section section = history_section(history_sample());
  EXPECT_TRUE(
      section.paragraphs.at(0).starts_with("After 3 commits, 0 of 2 candidates take fewer "))
      << section.paragraphs.at(0);
  EXPECT_EQ(section.numbers.at(2), "largest rise: +3.0 %");
  const Table &lines = section.tables.at(0), &moves = section.tables.at(1);
  EXPECT_EQ(entry_at(lines, {"1"}, "young").shown, missing_mark);
  EXPECT_EQ(entry_at(lines, {"2"}, "old").shown, "1.019");
  EXPECT_EQ(entry_at(lines, {"3"}, "young").shown, "1.030 moved");
  ASSERT_EQ(moves.rows.size(), 1u);
  expect_row(moves, {"ccc"}, {{"change", "+3.0 %"}, {"before", "2000"}});
  const Json spec = Json::parse(figures({"", {section}}).at(0).content);
  EXPECT_EQ(spec["params"][0]["value"], Json({"old", "young"}));
}

}  // namespace
}  // namespace desmo::report::instructions_test
