// Instructions a step: reader and tables.

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

}  // namespace
}  // namespace desmo::report::instructions_test
