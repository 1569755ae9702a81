// Which records may be compared, and the comparison.
#include "report/comparability.h"

#include <gtest/gtest.h>

#include "report/comparison.h"
#include "report/record_reader.h"
#include "tests/report/sample.h"

namespace desmo::report::comparability_test {
namespace {

Json newest() { return Json::parse(read_text(data_file("golden/1.3.0.json"))); }

std::vector<std::string> reasons(const Json& a, const Json& b) {
  std::vector<std::string> names;
  for (const Difference& d : why_incomparable(record_from(a), record_from(b)))
    names.push_back(d.what);
  return names;
}

using Names = std::vector<std::string>;

TEST(Comparability, TwoRunsOfOneMachineAndBuildAreComparable) {
  Json other = newest();
  other["record"]["date"] = "2030-01-01T00:00:00Z";
  other["record"]["commit"] = "another";
  other["record"]["build"]["binary"] = std::string(64, 'b');
  other["record"]["machine"]["load_before"] = {5, 5, 5};
  other["cells"][0]["cpu_seconds"][0] = 1;
  EXPECT_EQ(reasons(newest(), other), Names{});
}

TEST(Comparability, NamesEveryPartOfTheKeyThatDiffers) {
  const std::vector<std::tuple<const char*, Json, std::string>> changes{
      {"/record/build/compiler", "Clang 20.1.0", "compiler"},
      {"/record/build/type", "Debug", "build type"},
      {"/record/build/flags", "-O2", "flags"},
      {"/record/build/link/type", "static", "linking"},
      {"/record/build/link/flags", "-flto", "linking"},
      {"/record/blas/core", "Haswell", "BLAS core"},
      {"/record/blas/threads", 2, "BLAS threads"},
      {"/record/settings/tolerance", 1e-6, "tolerance"},
      {"/record/settings/max_iterations", 5, "iterations at most"},
      {"/record/settings/guess", "none", "first guess"},
      {"/record/settings/clock", "sundial", "clock"},
  };
  for (const auto& [place, value, name] : changes) {
    Json other = newest();
    other[Json::json_pointer(place)] = value;
    EXPECT_EQ(reasons(newest(), other), Names{name});
    EXPECT_EQ(reasons(other, newest()), Names{name});
  }
  Json other = newest();
  set_motion(other, 2, 0.02);
  EXPECT_EQ(reasons(newest(), other), Names{"step"});
  set_motion(other, 3);
  EXPECT_EQ(reasons(newest(), other), Names{"duration"});
}

TEST(Comparability, NamesBothValues) {
  Json other = newest();
  other["record"]["blas"]["core"] = "Abacus";
  const auto found = why_incomparable(record_from(newest()), record_from(other));
  const std::string core = newest()["record"]["blas"]["core"];
  EXPECT_EQ(describe(found), "BLAS core: " + core + " here, Abacus there\n");
}

// There is nothing to pair with a record before 1.4.0: both by their medians.
TEST(Comparability, ARecordWithSegmentsIsComparedByItsMediansWithOneWithout) {
  const Json old = newest();
  const Json record = with_windows(old);
  const auto note = [](const Json& a, const Json& b) {
    return table_named(make_comparison(record_from(a), record_from(b)), "comparison").notes[0];
  };
  EXPECT_EQ(reasons(record, old), Names{});
  EXPECT_TRUE(note(record, record).starts_with("Undisturbed time ±"));
  EXPECT_TRUE(note(record, old).starts_with("Median ±"));
  EXPECT_TRUE(note(old, record).starts_with("Median ±"));
}

// In the whole record: the CPU, the model of a case and size, its results.
Json replaced(const Json& record, const std::string& from, const std::string& to) {
  std::string text = record.dump();
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return Json::parse(text);
}

TEST(Comparability, AnotherMachineModelOrResultIsNamedOnce) {
  const Json record = newest();
  const std::string cpu = record["record"]["machine"]["cpu"], model = record["cells"][0]["model"],
                    results = record["cells"][0]["results"];
  const std::string place = record["cells"][0]["case"].get<std::string>() + "/" +
                            std::to_string(record["cells"][0]["coordinates"].get<int>());
  const std::string other(64, 'f');
  EXPECT_EQ(reasons(record, replaced(record, cpu, "Other CPU")), Names{"CPU model"});
  EXPECT_EQ(reasons(record, replaced(record, model, other)), Names{"model of " + place});
  EXPECT_EQ(reasons(record, replaced(record, results, other)), Names{"results of " + place});
}

TEST(Comparability, WhatIsNotRecordedIsNotTheSame) {
  const Json old = Json::parse(read_text(data_file("golden/1.2.0.json")));
  const auto found = why_incomparable(record_from(old), record_from(old));
  ASSERT_FALSE(found.empty());
  for (const Difference& d : found) {
    EXPECT_EQ(d.first, "not recorded") << d.what;
    EXPECT_EQ(d.second, "not recorded") << d.what;
  }
}

TEST(Comparability, WithoutACellInCommonThereIsNothingToCompare) {
  Json other = newest();
  for (Json& cell : other["cells"]) cell["id"] = "other_" + cell["id"].get<std::string>();
  for (Json& request : other["requests"]) request["request"] = "other";
  EXPECT_EQ(reasons(newest(), other), Names{"cells in common"});
}

TEST(Comparability, AnotherMajorVersionIsNotComparable) {
  const Record record = record_from(newest());
  Record later = record;
  later.version = "2.0.0";
  const auto found = why_incomparable(record, later);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].what, "schema");
}

TEST(Comparison, GivesTheRatioOfTheMediansAndItsInterval) {
  Json a = newest(), b = newest();
  const auto truck = [](Json& record) -> Json& {
    return cell_of(record, "truck_suspension", 114, "global_automatic_klu");
  };
  truck(a).erase("repetitions");
  truck(b).erase("repetitions");
  truck(a)["cpu_seconds"] = {2.02, 1.98, 2.0};
  truck(b)["cpu_seconds"] = {1.01, 0.99, 1.0};
  const Document document = make_comparison(record_from(a), record_from(b));
  const Entry ratio = entry_at(table_named(document, "comparison"),
                               {"truck_suspension", "114", "global_automatic_klu"}, "A over B");
  EXPECT_EQ(ratio.shown, "2.00 [1.96, 2.04] (50.0 %)");
  truck(b)["cpu_seconds"] = {1.2, 0.9, 1.0};
  EXPECT_EQ(entry_at(table_named(make_comparison(record_from(a), record_from(b)), "comparison"),
                     {"truck_suspension", "114", "global_automatic_klu"}, "A over B")
                .note,
            inconclusive_mark);
}

TEST(Comparison, ShowsNoTimeOfWhatFailedInEither) {
  const std::vector<std::string> row{"truck_suspension", "114", "global_automatic_klu"};
  Json failed = newest();
  cell_of(failed, row[0], 114, row[2])["verification"]["velocity"] = 1;
  EXPECT_EQ(reasons(newest(), failed), Names{});
  const Table table =
      table_named(make_comparison(record_from(newest()), record_from(failed)), "comparison");
  EXPECT_TRUE(entry_at(table, row, "A").has_number());
  EXPECT_EQ(entry_at(table, row, "B").shown, failed_mark);
  EXPECT_EQ(entry_at(table, row, "A over B").shown, failed_mark);
  EXPECT_EQ(entry_at(table, row, "remark").shown, "B: velocity differs by 1, 1e-08 is allowed");
}

TEST(Comparison, MarksWhatOnlyOneOfThemHas) {
  Json b = newest();
  erase_cell(b, "truck_suspension", 114, "global_automatic_klu");
  const Table table =
      table_named(make_comparison(record_from(newest()), record_from(b)), "comparison");
  EXPECT_EQ(entry_at(table, {"truck_suspension", "114", "global_automatic_klu"}, "A over B").shown,
            missing_mark);
}

}  // namespace
}  // namespace desmo::report::comparability_test
