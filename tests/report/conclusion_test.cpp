#include <gtest/gtest.h>

#include "report/report.h"
#include "report/tables/tables.h"
#include "report/variants.h"
#include "tests/report/sample.h"

namespace desmo::report::conclusion_test {
namespace {

std::string last_paragraph(const Json& json) {
  return conclusion(record_from(json)).paragraphs.back();
}

// The paper's own speed-ups, for one family.
void set_like_the_paper(Json& json, const std::string& family) {
  set_family(json, "global_automatic_" + family, 7.1);
  set_family(json, "group_automatic_" + family, 5.7);
  set_family(json, "group_automatic_lapack", 2.7);
  set_family(json, "group_symbolic_" + family, 3.5);
  set_family(json, "group_symbolic_lapack", 1.9);
}

TEST(Conclusion, HoldsWhereTheNumbersAreThePapers) {
  Json json = complete_record();
  for (const char* family : {"cholmod", "umfpack", "klu"}) set_like_the_paper(json, family);
  const std::string text = last_paragraph(json);
  EXPECT_NE(text.find("The paper's conclusion holds with every sparse solver"), std::string::npos)
      << text;
  EXPECT_NE(text.find("TS-TPS_LAP, the paper's fastest variant, is 3.5 times as fast as its global "
                      "reference with MA27; here 3.74 times with cholmod, 3.74 times with umfpack "
                      "and 3.74 times with klu."),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("ranking of the four variants is the paper's with cholmod, umfpack and klu"),
            std::string::npos)
      << text;
}

TEST(Conclusion, FollowsTheNumbersWhenOneSolverReversesIt) {
  Json json = complete_record();
  for (const char* family : {"cholmod", "umfpack"}) set_like_the_paper(json, family);
  set_family(json, "global_automatic_klu", 0.5);  // faster than every LAPACK variant
  set_family(json, "group_automatic_klu", 0.4);
  set_family(json, "group_symbolic_klu", 0.3);
  const std::string text = last_paragraph(json);
  EXPECT_NE(text.find("The choice of the sparse solver changes the conclusion."),
            std::string::npos);
  EXPECT_NE(text.find("LAPACK beats the sparse solver holds with cholmod and umfpack; is reversed "
                      "with klu."),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("holds except for TS-TPA_LAP (slower), TS-TPS_LAP (slower) with klu"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("symbolic equations beat automatic ones holds with cholmod, umfpack and klu"),
            std::string::npos)
      << text;
}

TEST(Conclusion, IsReversedThroughout) {
  Json json = complete_record();
  for (const std::string family : {"cholmod", "umfpack", "klu"}) {
    set_family(json, "global_automatic_" + family, 1);
    set_family(json, "group_automatic_" + family, 2);
    set_family(json, "group_symbolic_" + family, 3);
  }
  set_family(json, "group_automatic_lapack", 4);
  set_family(json, "group_symbolic_lapack", 5);
  const Table table = conclusion(record_from(json)).tables.front();
  for (const std::string_view family : stand_ins) {
    for (std::size_t row = 0; row < 3; ++row)
      EXPECT_EQ(entry_at(table, {table.rows[row][0].shown}, std::string(family)).shown,
                "is reversed");
    EXPECT_EQ(entry_at(table, {"ranking of the four variants"}, std::string(family)).shown,
              "is another than the paper's");
  }
  EXPECT_NE(last_paragraph(json).find("the verdict is the same, and it is not the paper's"),
            std::string::npos);
}

TEST(Conclusion, IsUndecidedWhereTheSpreadReachesEquality) {
  Json json = complete_record();
  set_like_the_paper(json, "klu");
  for (const char* id : {"group_automatic_klu", "group_automatic_lapack", "group_symbolic_klu",
                         "group_symbolic_lapack"})
    set_family(json, id, 2, 0.1);
  const Table table = conclusion(record_from(json)).tables.front();
  EXPECT_EQ(entry_at(table, {"solving by groups beats solving globally"}, "klu").shown, "holds");
  EXPECT_EQ(entry_at(table, {"symbolic equations beat automatic ones"}, "klu").shown,
            "is undecided within the spread");
  EXPECT_EQ(entry_at(table, {"ranking of the four variants"}, "klu").shown,
            "is the paper's within the spread");
}

TEST(Conclusion, UsesOnlySizesWhereAllWereMeasuredAndSaysSo) {
  Json json = complete_record();
  set_like_the_paper(json, "klu");
  set_samples(json, 558, "group_symbolic_lapack", {100});  // must not count: see the next line
  fail_cell(json, truck, 558, "global_automatic_klu");
  const Section section = conclusion(record_from(json));
  EXPECT_EQ(section.paragraphs[3],
            "With klu (4 of the paper's 5 sizes only): TS-TPS_LAP 3.74, TS-TPA_LAP 2.63, "
            "TS-TPS_klu 2.03 and TS-TPA_klu 1.25.");
}

TEST(Conclusion, SaysNothingWithoutNumbers) {
  Json json = complete_record();
  for (const char* family : {"cholmod", "umfpack", "klu"}) erase_family(json, family);
  const Section section = conclusion(record_from(json));
  EXPECT_EQ(section.paragraphs.back(),
            "Nothing can be said: the record has no cell of a sparse solver.");
  EXPECT_TRUE(section.tables.empty());
}

TEST(Conclusion, ReadsWellWithOneSolver) {
  Json json = complete_record();
  for (const char* family : {"cholmod", "umfpack"}) erase_family(json, family);
  set_like_the_paper(json, "klu");
  const Section section = conclusion(record_from(json));
  EXPECT_EQ(section.paragraphs.size(), 3u);
  EXPECT_EQ(section.tables.front().columns.size(), 2u);
  EXPECT_EQ(section.paragraphs.back(),
            "The paper's conclusion holds with klu, the one sparse solver that can be judged. "
            "TS-TPS_LAP, the paper's fastest variant, is 3.5 times as fast as its global reference "
            "with MA27; here 3.74 times with klu. That solving by groups beats solving globally "
            "holds with klu. That symbolic equations beat automatic ones holds with klu. That in "
            "the groups, LAPACK beats the sparse solver holds with klu. The ranking of the four "
            "variants is the paper's with klu.");
  set_family(json, "group_symbolic_lapack", 5);
  EXPECT_EQ(last_paragraph(json).rfind("With klu, the one sparse solver that can be judged, the "
                                       "verdict is not the paper's in every point.",
                                       0),
            0u)
      << last_paragraph(json);
}

}  // namespace
}  // namespace desmo::report::conclusion_test
