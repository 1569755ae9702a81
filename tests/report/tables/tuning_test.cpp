// What the choices of desmo tune are worth: reader, table, sentence.
#include <gtest/gtest.h>

#include "report/report.h"
#include "report/statistics/comparability.h"
#include "report/tables/tables.h"
#include "tests/report/points_sample.h"

namespace desmo::report::tuning_test {
namespace {

Json candidate(const std::string& id, double error, double microseconds) {
  return {{"id", id},
          {"error", error},
          {"time_per_step",
           {{"clock", "cpu"},
            {"seconds", {1.1e-6 * microseconds, 1e-6 * microseconds, 1.02e-6 * microseconds}}}}};
}

Json promise(double allowed, const Json& choice, const Json& best) {
  return {{"mechanism", "rssr"}, {"coordinates", 13},  {"step_seconds", 0.0025},
          {"instants", 401},     {"allowed", allowed}, {"promised", allowed / 4},
          {"compared", 333},     {"tried", 4000},      {"choice", choice},
          {"best", best}};
}

Json promises_record() {
  Json record = points_record();
  record.erase("accuracy");
  const Json fast = candidate("block_symbolic_inlined/iterations:1", 3e-4, 2),
             faster = candidate("group_symbolic_inlined/iterations:1", 4e-4, 1.6);
  record["accuracy"]["tuning"] = {promise(1e-3, fast, faster), promise(1e-9, fast, fast)};
  return record;
}

TEST(Promises, StandBesideWhatWasMeasured) {
  const Section section = tuning_sections(record_from(promises_record())).at(1);
  EXPECT_EQ(
      section.paragraphs,
      std::vector<std::string>{
          "The error asked for is held in 1 of 2 searches. The choice takes at most 1.10 "
          "times as long as the best there is in 1 of 2; the most is 1.25, of rssr at 0.001."});
  const Table& table = section.tables.front();
  const std::vector<std::string> kept{"rssr", "13", "0.001"}, broken{"rssr", "13", "1e-09"};
  EXPECT_EQ(entry_at(table, kept, "promised").shown, "2.5e-04");
  EXPECT_EQ(entry_at(table, kept, "measured").shown, "3.0e-04");
  EXPECT_EQ(entry_at(table, kept, "promise").shown, "kept");
  EXPECT_EQ(entry_at(table, kept, "times the best's").shown, "1.25 [1.23, 1.28]");
  EXPECT_EQ(entry_at(table, kept, "best").shown, "group_symbolic_inlined/iterations:1");
  EXPECT_EQ(entry_at(table, broken, "promise").shown, "BROKEN");
  EXPECT_EQ(entry_at(table, broken, "times the best's").shown, "1.00 itself");
}

TEST(Promises, HaveAPageOfTheirOwnOrWithPoints) {
  Json measured = points_record(), tuned = promises_record();
  for (Json* json : {&measured, &tuned})
    (*json)["record"] = Json::parse(read_text(data_file("origins.json")))["record"];
  const Record points = record_from(measured), record = record_from(tuned);
  EXPECT_EQ(make_report(record).sections.at(1).title, "What desmo tune promises");
  EXPECT_EQ(table_named(make_report({&points, &record}), "tuning").rows.size(), 2u);
  EXPECT_TRUE(why_apart(points, record).empty());
  const auto apart = why_apart(record, record);
  ASSERT_EQ(apart.size(), 1u);
  EXPECT_EQ(apart.front().what, "one record with tuning");
}

TEST(Promises, ThatSayNothingAreRefused) {
  const auto with = [](const std::string& place, const Json& value) {
    Json json = promises_record();
    json[Json::json_pointer(place)] = value;
    return complaint(json);
  };
  EXPECT_EQ(complaint(promises_record()), "accepted");
  EXPECT_NE(with("/accuracy/tuning/0/choice/time_per_step/seconds", Json::array())
                .find("/accuracy/tuning/0/choice/time_per_step/seconds: at least one sample"),
            std::string::npos);
  EXPECT_NE(with("/accuracy/tuning/1/allowed", 1e-3)
                .find("/accuracy/tuning/1: the promise of 0.001 for rssr"),
            std::string::npos);
  EXPECT_NE(with("/accuracy/tuning/0/best/error", -1).find("/accuracy/tuning/0/best/error: "),
            std::string::npos);
  Json json = promises_record();
  json["accuracy"]["tuning"] = Json::array();
  EXPECT_NE(complaint(json).find("nothing was measured"), std::string::npos);
}

}  // namespace
}  // namespace desmo::report::tuning_test
