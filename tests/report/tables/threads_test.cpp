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

/// A formulation on two threads, and, to be compared with, on one by the same clock and by the
/// other.
Json threads_record() {
  Json json = requests_record();
  const Json one = timed(candidate_of(json, 114, "global_automatic_klu"), hermite_lanes, 0.05);
  Json by_wall = timed(one, std::string(hermite_lanes) + "/clock:wall", 0.06);
  by_wall["time"]["clock"] = "wall";
  Json several = timed(by_wall, std::string(hermite_lanes) + "/threads:2", 0.03);
  several["threads"] = 2;
  for (const Json& candidate : {one, several, by_wall})
    json["paper"]["candidates"].push_back(candidate);
  return json;
}

TEST(Threads, StandInATableOfTheWallClockAlone) {
  const Document document = make_report(record_from(threads_record()));
  const Table table = table_named(document, "threads_truck_suspension");
  expect_row(table, {"114", "everything", hermite_lanes, "2"},
             {{"wall s", "0.03000 …"}, {"times one thread", "2.00 [2.00, 2.00]"}});
  EXPECT_EQ(table.rows.size(), 2u);
  for (const Table& other : tables_of(document))
    for (const auto& row : other.rows)
      for (const Entry& entry : row)
        EXPECT_TRUE(other.name == table.name || entry.shown.find("threads:") == std::string::npos)
            << other.name;
}

TEST(Threads, HaveNoRatioOverCpuTime) {
  Json json = threads_record();
  json["paper"]["candidates"].erase(json["paper"]["candidates"].size() - 1);
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
