// What the choices of desmo tune are worth: reader, table, sentence.
#include <gtest/gtest.h>

#include "report/comparability.h"
#include "report/report.h"
#include "report/tables/precision.h"
#include "tests/report/points_sample.h"

namespace desmo::report::promises_test {
namespace {

Json rival(const std::string& id, double error, double microseconds) {
  return {
      {"id", id},
      {"error", error},
      {"seconds_per_step", {1.1e-6 * microseconds, 1e-6 * microseconds, 1.02e-6 * microseconds}}};
}

Json promise(double allowed, const Json& choice, const Json& best) {
  return {{"mechanism", "rssr"}, {"coordinates", 13},  {"step_seconds", 0.0025},
          {"instants", 401},     {"allowed", allowed}, {"promised", allowed / 4},
          {"compared", 333},     {"tried", 4000},      {"choice", choice},
          {"best", best}};
}

Json promises_record() {
  Json record = points_record();
  for (const char* list : {"floors", "precision"}) record.erase(list);
  const Json fast = rival("block_symbolic_inlined/iterations:1", 3e-4, 2),
             faster = rival("group_symbolic_inlined/iterations:1", 4e-4, 1.6);
  record["promises"] = {promise(1e-3, fast, faster), promise(1e-9, fast, fast)};
  return record;
}

TEST(Promises, StandBesideWhatWasMeasured) {
  const Section section = promises(record_from(promises_record()));
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
    (*json)["record"] = Json::parse(read_text(data_file("golden/1.3.0.json")))["record"];
  const Record points = record_from(measured), record = record_from(tuned);
  EXPECT_EQ(make_report(record).sections.front().title, "What desmo tune promises");
  EXPECT_EQ(table_named(make_report(std::vector{points, record}), "promises").rows.size(), 2u);
  EXPECT_TRUE(why_apart(points, record).empty());
  const auto apart = why_apart(record, record);
  ASSERT_EQ(apart.size(), 1u);
  EXPECT_EQ(apart.front().what, "one record with promises");
}

TEST(Promises, ThatSayNothingAreRefused) {
  const auto with = [](const std::string& place, const Json& value) {
    Json json = promises_record();
    json[Json::json_pointer(place)] = value;
    return complaint(json);
  };
  EXPECT_EQ(complaint(promises_record()), "accepted");
  EXPECT_NE(with("/promises/0/choice/seconds_per_step", Json::array())
                .find("promises[0].choice.seconds_per_step: at least one sample"),
            std::string::npos);
  EXPECT_NE(with("/promises/1/allowed", 1e-3).find("promises[1]: the promise of 0.001 for rssr"),
            std::string::npos);
  EXPECT_NE(with("/promises/0/best/error", -1).find("promises[0].best.error: "), std::string::npos);
  Json json = promises_record();
  json["promises"] = Json::array();
  EXPECT_NE(complaint(json).find("nor extremes"), std::string::npos);
}

}  // namespace
}  // namespace desmo::report::promises_test
