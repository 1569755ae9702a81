#include "report/statistics/paper.h"
#include "report/statistics/variants.h"
#include "report/text/digits.h"
#include "tests/report/sample.h"

namespace desmo::report::tables_test {
namespace {

TEST(Paper, HoldsThePublishedTables) {
  EXPECT_EQ(published_sizes(), (std::vector<std::int64_t>{114, 225, 336, 447, 558}));
  EXPECT_EQ(published(published_cpu_seconds, "558", "TS-G_MA27"), "7.100");
  EXPECT_EQ(published(published_cpu_seconds, "558", "FBL-TP"), "<<0.015");
  EXPECT_FALSE(read_number(published(published_cpu_seconds, "558", "FBL-TP")));
  EXPECT_EQ(published(published_cpu_seconds, "1002", "FBL-TP"), "");
  EXPECT_EQ(read_number(published(published_speed_up, "mean", "TS-TPS_LAP")), 3.5);
  EXPECT_EQ(published(published_improvement_percent, "mean", "TS-TPA_MA27"), "14.1");
}

// The report's own arithmetic, applied to the paper's times, gives the paper's table 2: within the
// rounding, but for 225 coordinates and TS-TPA_MA27, where the paper prints 14.8 % and its times
// give 14.1 %.
TEST(Paper, TableTwoFollowsFromTableOne) {
  for (const PaperVariant& variant : topological)
    for (const std::int64_t size : published_sizes()) {
      const std::string row = std::to_string(size);
      const std::string column(variant.paper_name);
      const double global = *read_number(published(published_cpu_seconds, row, "TS-G_MA27"));
      const double group = *read_number(published(published_cpu_seconds, row, column));
      const double rounding = row == "225" && column == "TS-TPA_MA27" ? 0.7 : 0.11;
      EXPECT_NEAR(*read_number(published(published_speed_up, row, column)), global / group, 0.0501);
      EXPECT_NEAR(*read_number(published(published_improvement_percent, row, column)),
                  100 * (1 - group / global), rounding)
          << row << " " << column;
    }
}

/// An entry of the paper's tables, and what it shows.
struct Shown {
  const char *table, *row, *source, *column, *text;
};

void expect_shown(const Json& json, const std::vector<Shown>& entries) {
  const Document document = make_report(record_from(json));
  for (const auto& [table, row, source, column, text] : entries) {
    SCOPED_TRACE(std::string(table) + ", " + row);
    expect_row(table_named(document, table), {row, source}, {{column, text}});
  }
}

TEST(PapersTables, ShowMediansAndTheirRatiosAboveThePaper) {
  Json json = complete_record();
  set_samples(json, 114, "global_automatic_klu", {0.5, 0.3, 0.4});
  set_samples(json, 114, "global_automatic_umfpack", {6, 8, 10});
  set_samples(json, 114, "group_symbolic_lapack", {5, 2, 3});
  set_samples(json, 225, "global_automatic_umfpack", {8, 8, 8});
  set_samples(json, 225, "group_symbolic_lapack", {2, 2, 2});
  set_samples(json, 336, "global_automatic_klu", {1, 1, 1});
  set_samples(json, 336, "group_automatic_lapack", {4, 4, 4});
  expect_shown(json, {{"table1_klu", "114", "ours", "TS-G_klu", "0.4000"},
                      {"table1_klu", "114", "paper", "TS-G_klu", "1.258"},
                      {"table1_klu", "114", "paper", "FBL-TP", "<<0.015"},
                      {"table1_klu", "1002", "ours", "TS-G_klu", missing_mark},
                      {"table2_umfpack", "114", "ours", "TS-TPS_LAP",
                       "2.67 [1.20, 5.00] (62.5 %) inconclusive"},  // 8/3, from 6/5 to 10/2
                      {"table2_umfpack", "114", "paper", "TS-TPS_LAP", "3.4 (70.3 %) in"},
                      {"table2_umfpack", "225", "ours", "TS-TPS_LAP", "4.00 [4.00, 4.00] (75.0 %)"},
                      {"table2_umfpack", "225", "paper", "TS-TPS_LAP", "3.5 (71.8 %) out"},
                      // An improvement below zero is none: the ratio says how slow.
                      {"table2_klu", "336", "ours", "TS-TPA_LAP", "0.25 [0.25, 0.25]"}});
  const Table table = table_of(json, "table1_klu");
  EXPECT_EQ(table.notes.size(), 2u);  // of the same motion, there is none on two
  EXPECT_EQ(table.columns.size(), 2u + 7);
  EXPECT_TRUE(entry_at(table, {"1002", "ours"}, "FBL-TP").has_number());
  EXPECT_THROW(entry_at(table, {"1002", "paper"}, "FBL-TP"), std::runtime_error);
}

TEST(PapersTables, ShowNoIntervalOfFewerThanThreeRepetitions) {
  Json json = complete_record();
  EXPECT_LACKS(table_of(json, "table2_klu").notes[0], "one digit");
  set_samples(json, 114, "global_automatic_klu", {1.258, 1.3});
  set_samples(json, 225, "global_automatic_klu", {5.499});
  expect_shown(json, {{"table1_klu", "114", "ours", "TS-G_klu", "1"},
                      {"table1_klu", "225", "ours", "TS-G_klu", "5"},
                      {"table2_klu", "114", "ours", "TS-TPA_klu", "40"}});
  EXPECT_CONTAINS(table_of(json, "table2_klu").notes[0], "one digit: of one or two repetitions");
}

TEST(PapersTables, MarkWhatHasNoTime) {
  Json json = complete_record();
  fail_candidate(json, 225, "group_automatic_lapack");
  erase_candidate(json, 336, "group_automatic_lapack");
  candidate_of(json, 447, "group_automatic_lapack")["status"] = "not_run";
  fail_candidate(json, 558, "global_automatic_klu");
  expect_shown(json, {{"table1_klu", "225", "ours", "TS-TPA_LAP", failed_mark},
                      {"table1_cholmod", "336", "ours", "TS-TPA_LAP", missing_mark},
                      {"table1_umfpack", "447", "ours", "TS-TPA_LAP", not_run_mark},
                      {"table2_klu", "225", "ours", "TS-TPA_LAP", failed_mark},
                      {"table2_klu", "558", "ours", "TS-TPA_klu", "reference FAILED"},
                      {"table2_klu", "558", "ours", "TS-TPS_LAP", "reference FAILED"}});
}

// One is the ratio of the other.
TEST(PapersTables, ShowUndisturbedTimesAndDivideThem) {
  Json json = complete_record();
  set_samples(json, 114, "global_automatic_klu", {6, 4, 5});
  set_samples(json, 114, "group_symbolic_klu", {9, 2, 3});
  json = with_windows(json);
  expect_shown(json, {{"table1_klu", "114", "ours", "TS-G_klu", "4.000 (median 5.000)"},
                      {"table1_klu", "114", "ours", "TS-TPS_klu", "2.000 (median 3.000)"},
                      {"table2_klu", "114", "ours", "TS-TPS_klu", "2.00 [2.00, 2.00] (50.0 %)"}});
  const Table times = table_of(json, "table1_klu"), ratios = table_of(json, "table2_klu");
  EXPECT_CONTAINS(times.notes[0], "undisturbed time (and median)");
  EXPECT_CONTAINS(ratios.notes[0], "S, the time of TS-G_klu over the variant's [interval]");
  for (const Table& table : {times, ratios})
    EXPECT_TRUE(says(table.notes, "Undisturbed time: the sum, over 25 equal timing windows"));
}

TEST(PapersTables, TakeUndisturbedTimesFromSamplesOfWindows) {
  Json json = complete_record();
  set_samples(json, 114, "global_automatic_klu", {6, 4, 5});
  set_samples(json, 114, "group_symbolic_klu", {9, 2, 2.02});
  json = with_samples_of_windows(json);
  // 4/2; without the best repetition 4/2.02, and 5/2.
  expect_shown(json, {{"table1_klu", "114", "ours", "TS-G_klu", "4.000 (median 5.000)"},
                      {"table1_klu", "114", "ours", "TS-TPS_klu", "2.000 (median 2.020)"},
                      {"table2_klu", "114", "ours", "TS-TPS_klu",
                       "2.00 [1.98, 2.50] (50.0 %) inconclusive"}});
  EXPECT_TRUE(says(table_of(json, "table1_klu").notes, "lower convex envelope"));
}

// The family stands in columns and reference alike; a size that the paper does not have is a row of
// its own and no part of the mean.
TEST(PapersTables, AverageOverThePapersSizes) {
  Json json = complete_record();
  set_family(json, "global_automatic_cholmod", 3);
  set_family(json, "group_automatic_cholmod", 2);
  set_family(json, "group_automatic_lapack", 1);
  for (const auto& [id, seconds] :
       {std::pair{"global_automatic_cholmod", 9.0}, {"group_automatic_cholmod", 1.0}}) {
    Json extra = candidate_of(json, 558, id);
    extra["coordinates"] = 1113;
    extra["time"]["seconds"] = {seconds};
    json["paper"]["candidates"].push_back(extra);
  }
  fail_candidate(json, 225, "group_symbolic_cholmod");
  expect_shown(json,
               {{"table2_cholmod", "558", "ours", "TS-TPA_cholmod", "1.50 [1.47, 1.53] (33.3 %)"},
                {"table2_cholmod", "558", "ours", "TS-TPA_LAP", "3.00 [2.94, 3.06] (66.7 %)"},
                {"table2_cholmod", "558", "paper", "TS-TPA_LAP", "2.6 (62.0 %) out"},
                {"table2_cholmod", "1113", "ours", "TS-TPA_cholmod", "9"},
                {"table2_cholmod", "mean", "ours", "TS-TPA_cholmod", "1.50 [1.47, 1.53] (33.3 %)"},
                {"table2_cholmod", "mean", "ours", "TS-TPA_LAP", "3.00 [2.94, 3.06] (66.7 %)"},
                {"table2_cholmod", "mean", "paper", "TS-TPS_LAP", "3.5 (71.6 %) out"},
                // Of fewer sizes it is not compared.
                {"table2_cholmod", "mean", "paper", "TS-TPS_cholmod", "1.9 (47.4 %)"}});
  EXPECT_CONTAINS(
      entry_at(table_of(json, "table2_cholmod"), {"mean", "ours"}, "TS-TPS_cholmod").note,
      "incomplete 4/5");
}

TEST(EveryFormulation, OrdersAndReferencesTheFastestGlobal) {
  Json json = complete_record();
  set_samples(json, 558, "global_automatic_klu", {0.3, 0.2, 0.4});
  set_samples(json, 558, "group_symbolic_inlined", {0.1, 0.1, 0.1});
  fail_candidate(json, 558, "group_symbolic_klu");
  const Table table = table_of(json, "formulations_truck_suspension_558");
  EXPECT_EQ(table.rows.front().front().shown, "group_symbolic_inlined");
  expect_row(table, {"group_symbolic_inlined"},  // 0.1 s / 3001
             {{"speed-up", "3.00 inconclusive"}, {"µs/step", "33.32"}});
  expect_row(table, {"global_automatic_klu"},
             {{"CPU s", "0.3000 (0.2000 – 0.4000)"}, {"speed-up", "1.00 reference"}});
  expect_row(table, {"group_symbolic_klu"},
             {{"CPU s", failed_mark}, {"speed-up", failed_mark}, {"remark", "wrong by design"}});
  expect_row(table, {"global_automatic_lapack"}, {{"CPU s", not_run_mark}});
  EXPECT_CONTAINS(entry_at(table, {"global_automatic_lapack"}, "remark").shown, "O(n^3)");
}

TEST(TimeSplit, HasNoNumbersOfWhatFailed) {
  Json json = complete_record();
  fail_candidate(json, 558, "global_automatic_klu");
  expect_row(table_of(json, "time_split"), {truck, "558", "global_automatic_klu"},
             {{"total", failed_mark}, {"factorisation", failed_mark}});
}

TEST(Report, SkipsFamiliesWithoutACandidate) {
  Json json = complete_record();
  for (const char* family : {"cholmod", "umfpack"}) erase_family(json, family);
  const Document document = make_report(record_from(json));
  for (const Table& table : tables_of(document))
    for (const char* family : {"cholmod", "umfpack"}) {
      EXPECT_LACKS(table.name, family);
      for (const Column& column : table.columns) EXPECT_NE(column.name, family) << table.name;
    }
}

}  // namespace
}  // namespace desmo::report::tables_test
