
#include <stdexcept>

#include "report/statistics/measurements.h"
#include "tests/report/sample.h"

namespace desmo::report::threads_test {
namespace {

Json timed(Json like, const std::string& id, double seconds) {
  like["id"] = id;
  like["time"]["seconds"] = {seconds, seconds, seconds};
  return like;
}

constexpr const char* hermite_lanes = "group_symbolic_explicit/guess:hermite5/lanes:4";

/// The reference with better settings, and generated code with lanes, on everything and a request.
Json beyond_record() {
  Json json = requests_record();
  const Json candidate = candidate_of(json, truck, 114, "global_automatic_klu");
  candidate_of(json, truck, 114, "global_automatic_klu")["time"]["seconds"] = {0.8, 0.8, 0.8};
  json["paper"]["cells"].push_back(timed(candidate, "global_automatic_klu/guess:hermite5", 0.4));
  json["paper"]["cells"].push_back(timed(candidate, "group_symbolic_explicit", 0.1));
  json["paper"]["cells"].push_back(timed(candidate, hermite_lanes, 0.05));
  Json request = json["paper"]["requests"][0];
  request["case"] = truck;
  request["coordinates"] = 114;
  request["request"] = "some";
  request["title"] = "some of it";
  for (const auto& [id, seconds] : {std::pair{"global_automatic_klu", 0.6}, {hermite_lanes, 0.02}})
    json["paper"]["requests"].push_back(timed(request, id, seconds));
  return json;
}

/// The same on two threads, and, to be compared with, on one by the same clock.
Json threads_record() {
  Json json = beyond_record();
  Json several = candidate_of(json, truck, 114, hermite_lanes);
  several["time"]["clock"] = "wall";
  Json one = timed(several, std::string(hermite_lanes) + "/clock:wall", 0.06);
  several["id"] = std::string(hermite_lanes) + "/threads:2";
  several["threads"] = 2;
  several["time"]["seconds"] = {0.03, 0.03, 0.03};
  json["paper"]["cells"].push_back(several);
  json["paper"]["cells"].push_back(one);
  return json;
}

TEST(Threads, StandInATableOfTheWallClockAlone) {
  const Document document = make_report(record_from(threads_record()));
  const Table table = table_named(document, "threads_truck_suspension");
  const std::vector<std::string> two{"114", "everything", hermite_lanes, "2"};
  expect_row(table, two, {{"wall s", "0.03000 …"}, {"times one thread", "2.00 [2.00, 2.00]"}});
  EXPECT_EQ(table.rows.size(), 2u);
  for (const Section& section : document.sections)
    for (const Table& other : section.tables)
      for (const auto& row : other.rows)
        for (const Entry& entry : row)
          EXPECT_TRUE(other.name == table.name || entry.shown.find("threads:") == std::string::npos)
              << other.name;
}

TEST(Threads, HaveNoRatioOverCpuTime) {
  Json json = threads_record();
  json["paper"]["cells"].erase(json["paper"]["cells"].size() - 1);
  const Table table = table_of(json, "threads_truck_suspension");
  expect_row(table, {"114", "everything", hermite_lanes, "2"},
             {{"times one thread", "one thread not measured"}});
  const Record record = record_from(json);
  EXPECT_THROW(measured_speed_up(measured(record.candidates.begin()->second),
                                 measured(record.wall_candidates.begin()->second)),
               std::logic_error);
}

}  // namespace
}  // namespace desmo::report::threads_test
