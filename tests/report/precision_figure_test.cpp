#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "report/figures/figures.h"
#include "report/tables/tables.h"
#include "tests/report/points_sample.h"

namespace desmo::report::precision_figure_test {
namespace {

Json figure_of(const Json& record) {
  return Json::parse(work_precision_figure(record_from(record), "truck_suspension").content);
}

Json mark_of(const Json& spec, const std::string& id) {
  for (const Json& mark : spec["data"]["values"])
    if (mark["id"] == id) return mark;
  return nullptr;
}

TEST(WorkPrecision, HasOneFigureForEachCase) {
  const auto files = figures(record_from(points_record()));
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].file_name, "work_precision_four_bar.vl.json");
  EXPECT_EQ(files[1].file_name, "work_precision_truck_suspension.vl.json");
  Json both = structured_record();
  both["accuracy"] = points_record()["accuracy"];
  both["record"]["settings"]["step_seconds"] = 0.01;
  EXPECT_EQ(figures(record_from(both)).size(), 4u);
}

// Every row of the table has one mark, with its numbers.
TEST(WorkPrecision, DrawsWhatItsTableSays) {
  const Json json = points_record();
  const Table table = work_precision(record_from(json), "truck_suspension");
  const Json spec = figure_of(json);
  EXPECT_EQ(spec["title"]["text"], table.title);
  EXPECT_EQ(spec["title"]["subtitle"].size(), table.notes.size());
  EXPECT_EQ(table.title, "Work–precision: truck_suspension, 225 coordinates");
  ASSERT_EQ(spec["data"]["values"].size(), table.rows.size());
  EXPECT_EQ(table.rows.size(), 10u);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Json& mark = spec["data"]["values"][i];
    const auto& row = table.rows[i];
    EXPECT_EQ(mark["id"], row[0].shown);
    if (!row[2].has_number()) continue;
    EXPECT_EQ(mark["microseconds"], Json::parse(row[2].digits[0]));
    EXPECT_EQ(mark["drawn_at"], Json::parse(row[3].digits[0]));
    EXPECT_EQ(mark["shown_error"], row[3].shown);
    EXPECT_EQ(mark["iterations"], row[8].shown);
  }
  EXPECT_NE(table.notes[1].find("16 configurations solved, 1 failed (below, with their reason), 1 "
                                "not applicable"),
            std::string::npos);
}

TEST(WorkPrecision, TheFrontIsWhatNothingElseBeatsInBoth) {
  const Json spec = figure_of(points_record());
  std::set<std::string> front;
  for (const Json& mark : spec["data"]["values"])
    if (mark.value("front", false)) front.insert(mark["id"]);
  const std::string klu = "global_automatic_klu";
  EXPECT_EQ(front, (std::set<std::string>{klu + "/guess:hermite5/jacobian:step/iterations:1",
                                          klu + "/guess:hermite5/tolerance:1e-8",
                                          klu + "/guess:hermite5", klu}));
  EXPECT_TRUE(mark_of(spec, klu + "/guess:hermite5").contains("label"));
  EXPECT_FALSE(mark_of(spec, klu).contains("label"));  // no room: 1e-15 beside 2e-15
}

// Whatever beats them, a formulation's paper settings are drawn: they are what readers know.
TEST(WorkPrecision, DrawsOfEachFormulationWhatItsOtherSettingsDoNotBeat) {
  Json json = points_record();
  const std::string lapack = "group_symbolic_lapack";
  json["accuracy"]["points"].push_back(solved_point(lapack + "/guess:linear", 70, 5e-6));
  json["accuracy"]["points"].push_back(solved_point(lapack + "/guess:quadratic", 110, 1e-15));
  const Json spec = figure_of(json);
  EXPECT_NE(mark_of(spec, lapack), nullptr);  // "/guess:hermite5" is faster and more exact
  EXPECT_NE(mark_of(spec, lapack + "/guess:quadratic"), nullptr);
  EXPECT_EQ(mark_of(spec, lapack + "/guess:linear"), nullptr);
}

// What is not solved cannot be held against what is: apart from the line, in marks of its own.
TEST(WorkPrecision, WhatIsInterpolatedIsAFamilyApartFromTheFront) {
  Json json = points_record();
  const Json before = figure_of(json);
  json["accuracy"]["points"].push_back(solved_point("global_automatic_klu/stride:8", 5, 1e-9));
  const Json spec = figure_of(json), mark = mark_of(spec, "global_automatic_klu/stride:8");
  EXPECT_EQ(mark["family"], "interpolated");
  EXPECT_FALSE(mark["front"].get<bool>());
  for (const Json& other : before["data"]["values"]) EXPECT_EQ(mark_of(spec, other["id"]), other);
  EXPECT_EQ(spec["vconcat"][0]["layer"][0]["encoding"]["shape"]["scale"]["range"].back(),
            "diamond");
}

TEST(WorkPrecision, FailuresStandOnARailWithTheirReason) {
  Json json = points_record();
  const Json spec = figure_of(json);
  ASSERT_EQ(spec["vconcat"].size(), 2u);
  const Json failed = mark_of(spec, "group_symbolic_lapack/scalar:float");
  EXPECT_EQ(failed["reason"], "no convergence");
  EXPECT_EQ(failed["message"], "no convergence at t = 0.01 s, residual 1e-06, group 'axle1/i'");
  EXPECT_EQ(failed["place"], 1);
  EXPECT_FALSE(failed.contains("drawn_at"));
  point_of(json, "group_symbolic_lapack/scalar:float")["status"] = "not_applicable";
  EXPECT_EQ(figure_of(json)["vconcat"].size(), 1u);
}

// The floor lies far beyond what double precision reaches: at the edge, saying so.
TEST(WorkPrecision, DrawsTheFloorAndThePredictedLimits) {
  const Json spec = figure_of(points_record());
  const Json& panel = spec["vconcat"][0]["layer"];
  const double edge = panel[0]["encoding"]["x"]["scale"]["domain"][0].get<double>();
  for (const int layer : {3, 4}) {
    const Json& lines = panel[layer]["data"]["values"];
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0]["at"], edge);
    EXPECT_EQ(lines[0]["what"], "floor of the reference 4.0e-33, further left");
    EXPECT_EQ(lines[1]["at"], 1.1e-13);
    EXPECT_EQ(lines[1]["what"], "κ u, double 1.1e-13");
    EXPECT_EQ(lines[2]["at"], 6e-5);
  }
  Json json = points_record();
  json["accuracy"]["floors"][0].erase("condition");
  EXPECT_EQ(figure_of(json)["vconcat"][0]["layer"][3]["data"]["values"].size(), 1u);
}

// On an axis of logarithms there is no place for 0, and none for 1e60.
TEST(WorkPrecision, DrawsEveryErrorWithinItsAxis) {
  Json json = points_record();
  for (const auto& [id, error] :
       {std::pair{"block_automatic_klu", 0.0}, {"block_symbolic_klu", 1e60}})
    json["accuracy"]["points"].push_back(solved_point(id, 10, error));
  const Json spec = figure_of(json);
  const Json& domain = spec["vconcat"][0]["layer"][0]["encoding"]["x"]["scale"]["domain"];
  for (const char* id : {"block_automatic_klu", "block_symbolic_klu"}) {
    const double at = mark_of(spec, id)["drawn_at"].get<double>();
    EXPECT_LE(domain[0].get<double>(), at);
    EXPECT_LE(at, domain[1].get<double>());
  }
  EXPECT_EQ(mark_of(spec, "block_symbolic_klu")["shown_error"], "1.0e+60");
}

TEST(WorkPrecision, FamiliesKeepTheirMarksAndUnknownOnesGetACross) {
  Json json = points_record();
  json["accuracy"]["points"].push_back(solved_point("tearing_symbolic_klu", 10, 1e-9));
  const Json spec = figure_of(json);
  const Json& encoding = spec["vconcat"][0]["layer"][0]["encoding"];
  EXPECT_EQ(encoding["color"]["scale"]["domain"],
            Json({"global, sparse", "groups, sparse", "groups, dense", "other, sparse"}));
  EXPECT_EQ(encoding["color"]["scale"]["range"],
            Json({"#000000", "#0072b2", "#0072b2", "#888888"}));
  EXPECT_EQ(encoding["shape"]["scale"]["range"], Json({"circle", "circle", "square", "cross"}));
  EXPECT_EQ(spec["params"][0]["value"], encoding["color"]["scale"]["domain"]);
}

}  // namespace
}  // namespace desmo::report::precision_figure_test
