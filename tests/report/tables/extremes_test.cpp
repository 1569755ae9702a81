// The table of extremes: reader, tables, sentence.

#include "tests/report/sample.h"

namespace desmo::report::extremes_test {
namespace {

Json result(int row, const char* case_name, const char* id, const char* verdict) {
  Json json = {{"row", row}, {"case", case_name}, {"id", id}, {"verdict", verdict}};
  if (json["verdict"] != "as_expected") json["reason"] = "so it is";
  return json;
}

/// Adds errors to a result: in velocity a multiple of the floor of 1e-12, less at other levels.
Json compared(Json json, double times_floor) {
  const auto level = [](double error) { return Json{{"error", error}, {"floor", 1e-12}}; };
  json["worst"] = {{"position", level(1e-13)},
                   {"velocity", level(times_floor * 1e-12)},
                   {"acceleration", level(0)}};
  return json;
}

Json extremes_record() {
  Json record = empty_record();
  record["extremes"]["rows"] = {
      {{"row", 2}, {"name", "dead points"}, {"extreme", "near"}, {"expected", "right"}},
      {{"row", 3}, {"name", "singular"}, {"extreme", "exactly"}, {"expected", "flagged"}}};
  record["extremes"]["results"] = {compared(result(2, "a", "klu", "as_expected"), 2),
                                   compared(result(2, "b", "klu/tolerance:1e-13", "defect"), 4000),
                                   compared(result(2, "a", "eigen", "as_expected"), 3),
                                   result(2, "b", "eigen", "missed"),
                                   result(3, "c", "klu", "not_applicable"),
                                   result(3, "c", "eigen", "as_expected")};
  return record;
}

TEST(Extremes, AreATableOfFormulationsAndRows) {
  const Table table = extremes_sections(record_from(extremes_record())).at(0).tables.at(0);
  EXPECT_EQ(table.rows.size(), 2u);
  expect_row(table, {"klu"}, {{"2 dead points", "DEFECT 1 of 2, 4e+03"}, {"3 singular", "n/a"}});
  expect_row(table, {"eigen"}, {{"2 dead points", "missed 1 of 2, 3e+00"}, {"3 singular", "ok"}});
}

TEST(Extremes, BeginWithASentenceThatCountsDefects) {
  Json record = extremes_record();
  const Section front = extremes_sections(record_from(record)).at(0);
  EXPECT_EQ(front.numbers, (std::vector<std::string>{"results: 5", "less than expected: 1",
                                                     "wrong without a flag: 1"}));
  EXPECT_EQ(front.paragraphs.front(),
            "Wrong numbers without a flag, which is a defect whatever the residual, in 1 of 5 "
            "results; 3 are as expected, and 1 fall short of it without a wrong number.");
  record["extremes"]["results"].erase(1);
  EXPECT_TRUE(extremes_sections(record_from(record))
                  .at(0)
                  .paragraphs.front()
                  .starts_with("No wrong number without a flag in any of 4 results;"));
}

TEST(Extremes, NameTheReasonOfTheWorst) {
  const Section section = extremes_sections(record_from(extremes_record())).at(1);
  const Table& cases = section.tables.at(1);
  expect_row(cases, {"2", "b"}, {{"example", "klu/tolerance:1e-13: so it is"}, {"missed", "1"}});
}

TEST(Extremes, ThatSayNothingAreRefused) {
  expect_refusals(
      extremes_record(),
      {{"/extremes/results/0/verdict", "fine", ": \"fine\" is none of"},
       {"/extremes/results/0/row", 4, ": \"rows\" has no row 4"},
       {"/extremes/results/3/case", "a", "/extremes/results/3: eigen in \"a\" is given twice"},
       {"/extremes/results/3/reason", "", "/extremes/results/3: what is not as expected needs"},
       {"/extremes/rows/1/row", 2, "/extremes/rows/1: row 2 is given twice"},
       {"/extremes/results", Json::array(), "nothing was measured"}});
}

}  // namespace
}  // namespace desmo::report::extremes_test
