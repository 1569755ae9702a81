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

TEST(Threads, ShowTheRequestsOfTheWallClock) {
  Json json = threads_record();
  const Json request = json["paper"]["requests"][0];
  const std::string title = request["title"];
  for (const auto& [suffix, seconds] : {std::pair{"/threads:2", 0.01}, {"/clock:wall", 0.04}}) {
    json["paper"]["requests"].push_back(
        timed(request, hermite_lanes + std::string(suffix), seconds));
    json["paper"]["requests"].back()["time"]["clock"] = "wall";
  }
  const Document document = make_report(record_from(json));
  const Table table = table_named(document, "threads_truck_suspension");
  const std::string coordinates = std::to_string(request["coordinates"].get<int>());
  EXPECT_EQ(table.rows.size(), 4u);
  expect_row(table, {"114", "everything", hermite_lanes, "2"},
             {{"times one thread", "2.00 [2.00, 2.00]"}});
  expect_row(table, {coordinates, title, hermite_lanes, "2"},
             {{"wall s", "0.01000 …"}, {"times one thread", "4.00 [4.00, 4.00]"}});
  for (const auto& row : table_named(document, "requests_truck_suspension_" + coordinates).rows)
    EXPECT_LACKS(row[2].shown, hermite_lanes);
  fail(json["paper"]["requests"].back());
  EXPECT_EQ(failures(record_from(json)).size(), failures(record_from(threads_record())).size() + 1);
  json["paper"]["requests"].back()["id"] = "a_b_c/threads:x";
  EXPECT_CONTAINS(complaint(json), "\"a_b_c/threads:x\" has no number of threads");
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
