#include <gtest/gtest.h>

#include "report/report.h"
#include "report/tables/tables.h"
#include "tests/report/sample.h"

namespace desmo::report::beyond_test {
namespace {

Json timed(Json like, const std::string& id, double seconds) {
  like["id"] = id;
  like["cpu_seconds"] = {seconds, seconds};
  like.erase("repetitions");
  return like;
}

/// The reference with better settings, and generated code with lanes, on everything and a request.
Json beyond_record() {
  Json json = structured_record();
  const Json cell = cell_of(json, "truck_suspension", 114, "global_automatic_klu");
  cell_of(json, "truck_suspension", 114, "global_automatic_klu")["cpu_seconds"] = {0.8, 0.8};
  json["cells"].push_back(timed(cell, "global_automatic_klu/guess:hermite5", 0.4));
  json["cells"].push_back(timed(cell, "group_symbolic_explicit", 0.1));
  json["cells"].push_back(timed(cell, "group_symbolic_explicit/lanes:4", 0.05));
  for (Json& c : json["cells"]) c.erase("repetitions");
  Json request = json["requests"][0];
  request["case"] = "truck_suspension";
  request["coordinates"] = 114;
  request["request"] = "some";
  request["title"] = "some of it";
  for (const auto& [id, seconds] :
       {std::pair{"global_automatic_klu", 0.6}, {"group_symbolic_explicit/lanes:4", 0.02}})
    json["requests"].push_back(timed(request, id, seconds));
  return json;
}

Table table_of(const Json& json) {
  return table_named(make_report(record_from(json)), "beyond_truck_suspension");
}

TEST(Beyond, HoldsSettingsBesideTheReferenceThatDeliversTheSame) {
  const Table table = table_of(beyond_record());
  const auto shown = [&](const char* delivered, const char* id, const char* column) {
    return entry_at(table, {delivered, id}, column).shown;
  };
  const char *paper = "times the paper's settings", *best = "times its best settings";
  EXPECT_EQ(shown("everything", "global_automatic_klu", paper), "1.00 reference");
  EXPECT_EQ(shown("everything", "global_automatic_klu/guess:hermite5", best), "1.00 reference");
  EXPECT_EQ(shown("everything", "group_symbolic_explicit", paper), "8.00 [8.00, 8.00]");
  EXPECT_EQ(shown("everything", "group_symbolic_explicit/lanes:4", paper), "16.00 [16.00, 16.00]");
  EXPECT_EQ(shown("everything", "group_symbolic_explicit/lanes:4", best), "8.00 [8.00, 8.00]");
  EXPECT_EQ(shown("some of it", "group_symbolic_explicit/lanes:4", paper), "30.00 [30.00, 30.00]");
  EXPECT_EQ(shown("some of it", "group_symbolic_explicit/lanes:4", best), "30.00 [30.00, 30.00]");
  EXPECT_EQ(table.rows.size(), 6u);
}

TEST(Beyond, IsNotThereWithoutSettings) {
  EXPECT_TRUE(beyond(record_from(structured_record())).tables.empty());
}

TEST(Beyond, LeavesOutWhatStandsBesidePeers) {
  Json json = structured_record();
  const Json cell = cell_of(json, "truck_suspension", 114, "global_automatic_klu");
  json["cells"].push_back(timed(cell, "global_automatic_klu/guess:quadratic", 0.4));
  EXPECT_EQ(beyond(record_from(json)).tables.size(), 1u);
  json["peers"] = {{{"case", "truck_suspension"},
                    {"coordinates", 114},
                    {"peer", "other"},
                    {"library", "Other"},
                    {"library_version", "1"},
                    {"method", "its own"},
                    {"guess", "quadratic"},
                    {"status", "not_run"},
                    {"message", "too slow"}}};
  EXPECT_TRUE(beyond(record_from(json)).tables.empty());
}

}  // namespace
}  // namespace desmo::report::beyond_test
