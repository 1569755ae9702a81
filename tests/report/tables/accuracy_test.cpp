#include "report/formats/formats.h"
#include "tests/report/points_sample.h"

namespace desmo::report::accuracy_test {
namespace {

const std::string klu = "global_automatic_klu", lapack = "group_symbolic_lapack";
const std::string over_itself = "times as fast as with the paper's settings",
                  over_global = "as global_automatic_klu with them";

TEST(AccuracyCosts, StandInASentenceInFront) {
  Json json = points_record();
  const auto front = [&] { return accuracy_sections(record_from(json)).at(0); };
  EXPECT_EQ(front().paragraphs.at(0),
            "Exact to 1e-12, a step of truck_suspension takes 24.0 µs at the least, 1.67 times as "
            "fast as global_automatic_klu with the paper's guess and Jacobian; an error of 0.001 "
            "would save 33 % of it.");
  EXPECT_EQ(front().numbers, (std::vector<std::string>{"exact to 1e-06: 1.88 times as fast",
                                                       "exact to 1e-09: 2.00 times as fast",
                                                       "exact to 1e-12: 1.67 times as fast"}));
  for (Json& point : json["accuracy"]["points"])
    if (point["case"] == truck && point["status"] == "ok")
      point["error"] = solved_point(klu, 1, 0.5)["error"];
  EXPECT_EQ(front().paragraphs.at(0), "No configuration is exact to 0.001.");
  EXPECT_EQ(front().numbers.at(0),
            std::string("exact to 1e-06: ") + missing_mark + " times as fast");
}

// A formulation of the paper's tables is compared at the same error, with any guess and update.
TEST(AccuracyCosts, ComparesWithTheSameFormulationAtTheSameError) {
  Json json = points_record();
  json["accuracy"]["points"].push_back(
      solved_point("group_automatic_klu/guess:hermite5", 10, 1e-7));
  const Table table = table_of(json, "accuracy_costs");
  const std::vector<std::string> row{truck, "225", "1e-06"};
  EXPECT_EQ(entry_at(table, row, "cheapest").shown, "group_automatic_klu/guess:hermite5");
  EXPECT_EQ(entry_at(table, row, over_itself).digits[0], "3.30");  // 33 over 10
  EXPECT_EQ(entry_at(table, row, over_global).digits[0], "3.00");  // 30 over 10
}

// Solving every instant stands beside the cheapest of all, where that interpolates some.
TEST(AccuracyCosts, ShowWhatInterpolationGainsInARowOfItsOwn) {
  Json json = points_record();
  json["accuracy"]["points"].push_back(solved_point(klu + "/stride:8", 5, 1e-7, 0.4));
  const Table table = table_of(json, "accuracy_costs"),
              before = table_of(points_record(), "accuracy_costs");
  ASSERT_EQ(table.rows.size(), before.rows.size() + 2);  // at 1e-3 and 1e-6
  const std::string solved = klu + "/guess:hermite5/jacobian:step/iterations:1";
  EXPECT_EQ(entry_at(table, {truck, "225", "1e-06"}, "cheapest").shown, solved);
  const std::vector<std::string> second{truck, "225", "1e-06", klu + "/stride:8"};
  EXPECT_EQ(entry_at(table, second, "µs/step").digits[0], "5.000");
  EXPECT_EQ(entry_at(table, second, over_global).digits[0], "6.00");  // 30 over 5
}

TEST(AccuracyCosts, SaysWhereNothingHoldsTheError) {
  Json json = points_record();
  for (Json& point : json["accuracy"]["points"])
    if (point["case"] == "four_bar") point["error"]["position"]["max"] = 1e-5;
  const Table table = table_of(json, "accuracy_costs");
  expect_row(table, {"four_bar", "114", "1e-06"},
             {{"cheapest", "none"}, {"µs/step", missing_mark}, {over_itself, missing_mark}});
}

// A time of one sample cannot be had again as far as is known.
TEST(AccuracyCosts, OfOneSampleHaveNoInterval) {
  Json json = points_record();
  point_of(json, klu + "/guess:hermite5/jacobian:step/iterations:1")["time_per_step"]["seconds"] = {
      16e-6};
  const Table table = table_of(json, "accuracy_costs");
  expect_row(table, {truck, "225", "1e-09"}, {{"µs/step", "20"}, {over_itself, "2"}});
}

TEST(Guesses, AreComparedAtEqualErrorAndWithThePapersSettings) {
  const Table table = table_of(points_record(), "guesses_and_updates");
  EXPECT_EQ(table.rows.size(), 2u * 2 + 1) << "of each guess and update tried, and of no other";
  expect_row(table, {truck, "225", "hermite5", "step"},
             {{"stop", "iterations: 1"},
              {"times the paper's settings", "2.50 [2.45, 2.55]"},
              {"at equal error", "2.00 …"}});
  expect_row(table, {truck, "225", "previous", "newton"},  // 1.5e-9 is too much
             {{"stop", "tolerance 1e-8"}, {"at equal error", "1.00 reference"}});
  expect_row(table, {truck, "225", "previous", "step"}, {{"stop", "nothing that holds it"}});
}

// Points that interpolate instants are no part of the table: their gain is another one.
TEST(Guesses, AreOfEveryInstantSolved) {
  Json json = points_record();
  json["accuracy"]["points"].push_back(solved_point(klu + "/stride:2", 5, 1e-12, 1.5));
  json["accuracy"]["points"].push_back(
      solved_point(klu + "/guess:hermite5/jacobian:step/stride:2/tolerance:1e-10", 4, 1e-12, 0.5));
  const std::string name = "guesses_and_updates";
  EXPECT_EQ(to_csv(table_of(json, name)), to_csv(table_of(points_record(), name)));
}

TEST(Sensitivity, VariesOneThingAtATime) {
  const Table table = table_of(points_record(), "sensitivity");
  expect_row(table, {"klu", "step", "1 ms"},
             {{"TS-TPS_LAP", "0.40 [0.39, 0.41]"}, {"FBL-TP", missing_mark}});
  expect_row(table, {"klu", "step", "10 ms"},
             {{"TS-TPS_LAP", "0.40 …"}, {"TS-TPA_<sparse>", "1.03 …"}, {"FBL-TP", "6.00 …"}});
  EXPECT_EQ(entry_at(table, {"klu", "tolerance", "1e-06"}, "TS-TPS_LAP").digits[0], "0.36");
  EXPECT_EQ(entry_at(table, {"klu", "tolerance", "1e-12"}, "TS-TPS_LAP").digits[0], "0.40");
  EXPECT_EQ(entry_at(table, {"klu", "guess", "hermite5"}, "TS-TPS_LAP").digits[0], "0.35");
  EXPECT_EQ(table.rows.size(), 6u);  // two steps, two tolerances, two guesses; one family
}

TEST(Sensitivity, MarksWhatFailed) {
  Json json = points_record();
  fail(point_of(json, lapack + "/tolerance:1e-6"));
  expect_row(table_of(json, "sensitivity"), {"klu", "tolerance", "1e-06"},
             {{"TS-TPS_LAP", failed_mark}});
}

}  // namespace
}  // namespace desmo::report::accuracy_test
