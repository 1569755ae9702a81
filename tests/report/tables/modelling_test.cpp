// The paper's comparison in each kind of coordinates: reader, sentences, tables.

#include "report/report.h"
#include "tests/report/size_sample.h"

namespace desmo::report::modelling_test {
namespace {

TEST(ModellingTimes, ThatSayNothingAreRefused) {
  expect_refusals(modelling_record(),
                  {{"/modelling/times/0/entries", 0, ": "},
                   {"/modelling/times/0/condition", 0, ": "},
                   {"/modelling/times/0/status", "not_run", ": everything here is run"},
                   {"/modelling/times/1/id", "global_automatic_cholmod", "is given twice"},
                   {"/modelling", {{"times", Json::array()}}, "nothing was measured"}});
}

TEST(ModellingTables, CompareWithinGroupsWithKlu) {
  const Document document = make_report(record_from(modelling_record()));
  expect_row(table_named(document, "modelling_ratios"), {truck, "in groups, dense over KLU"},
             {{"relative", "0.25 …"}});
  expect_row(table_named(document, "modelling"), {truck, "basis", "group_automatic_klu", "558"},
             {{"unknowns", "279"}, {"condensation", "3906"}, {"condition", "80"}});
}

TEST(ModellingTables, ShowExactFramesInARowOfTheirOwn) {
  Json json = modelling_record();
  Json& times = json["modelling"]["times"];
  Json exact = times.back();
  exact["id"] = "group_automatic_klu/coordinates:relative/frames:exact";
  times.push_back(exact);
  expect_row(table_of(json, "modelling_in_short"), {"group_automatic_klu/frames:exact"},
             {{"natural", missing_mark}, {"relative", "27.9"}});
}

TEST(ModellingTables, StandBesideThoseOfAnotherMachine) {
  const Record here = record_from(modelling_record());
  const Record there =
      record_from(changed(modelling_record(), "/record/machine/cpu", "Another CPU"));
  const Table table = table_named(make_report(here, {&there}), "machines_modelling");
  EXPECT_FALSE(table.rows.empty());
}

// A size that failed is no part of a mean, and says so.
TEST(ModellingTables, HaveNoMeanOfFewerSizes) {
  Json json = modelling_record();
  fail(json["modelling"]["times"][0]);
  const Document document = make_report(record_from(json));
  expect_row(table_named(document, "modelling_ratios"),
             {truck, "group, dense, over global CHOLMOD"},
             {{"natural", missing_mark}, {"basis", "3.00 …"}});
  expect_row(table_named(document, "modelling"),
             {truck, "natural", "global_automatic_cholmod", "114"},
             {{"µs/step", failed_mark}, {"remark", "wrong by design"}});
}

}  // namespace
}  // namespace desmo::report::modelling_test
