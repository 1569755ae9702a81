#include "report/formats/formats.h"
#include "tests/report/sample.h"

namespace desmo::report::requests_test {
namespace {

constexpr const char* wheel = "one wheel centre, position";
constexpr const char* axle = "one axle, everything";

Table table_of(const Json& json) { return requests(record_from(json)).tables.at(0); }

Json& request_of(Json& json, const std::string& id, const std::string& name) {
  return element_with(json["paper"]["requests"], {{"id", id}, {"request", name}});
}

TEST(Requests, CostLessThanEverythingWithTheSameFormulation) {
  const Table table = table_of(requests_record());
  EXPECT_EQ(table.name, "requests_truck_suspension_225");
  expect_row(table, {wheel, "position", "block_symbolic_inlined"},
             {{"unknowns", "21 of 218"},
              {"CPU s", "0.0002000 ±0.0000040"},
              {"times cheaper", "40.00 [38.43, 41.63] (97.5 %)"},
              {"iterations/step", "2.25"}});
  EXPECT_EQ(entry_at(table, {wheel, "position", "global_automatic_klu"}, "times cheaper").digits[0],
            "30.00");
  expect_row(table, {"everything", "acceleration", "global_automatic_klu"},
             {{"unknowns", "218 of 218"}, {"times cheaper", "1.00 reference"}});
}

TEST(Requests, BeginWithWhatIsGained) {
  Json json = requests_record();
  const auto found = [&] { return requests(record_from(json)).paragraphs; };
  EXPECT_EQ(found(),
            (std::vector<std::string>{
                "On truck_suspension with 225 coordinates, a request is solved 2.00 to "
                "40.00 times as fast as everything by the same formulation; most is gained "
                "by “one wheel centre, position”, which needs 21 of 218 unknowns."}));
  for (Json& request : json["paper"]["requests"])
    if (request["request"] != "wheel_centre" || request["id"] != "block_symbolic_inlined")
      request["status"] = "failed";
  EXPECT_CONTAINS(found().at(0), "a request is solved 40.00 times as fast");
  for (Json& request : json["paper"]["requests"]) request["status"] = "failed";
  EXPECT_EQ(found(), (std::vector<std::string>{
                         "No request has a time next to everything by the same formulation."}));
}

TEST(Requests, ThatFailedOrDidNotRunHaveNoTime) {
  Json json = requests_record();
  request_of(json, "global_automatic_klu", "axle")["time"]["seconds"] = {0.001, 0.001};
  const Record record = record_from(json);
  for (const MeasuredRequest& request : record.requests)
    EXPECT_EQ(request.time.seconds.empty(), request.status != Status::ok);
  const Table table = table_of(json);
  expect_row(
      table, {axle, "acceleration", "global_automatic_klu"},
      {{"CPU s", failed_mark}, {"times cheaper", failed_mark}, {"remark", "wrong by design"}});
  expect_row(table, {wheel, "position", "group_symbolic_inlined"},
             {{"CPU s", not_run_mark}, {"times cheaper", not_run_mark}});
  const Document document = make_report(record);
  EXPECT_EQ(document.sections.back().paragraphs,
            (std::vector<std::string>{
                "FAILED: truck_suspension/225/global_automatic_klu/request:axle: wrong by "
                "design"}));
}

TEST(Requests, FailWhenTheyDifferMoreThanIsAllowed) {
  Json json = requests_record();
  Json& request = request_of(json, "block_symbolic_inlined", "axle");
  const std::vector<std::string> row{axle, "acceleration", "block_symbolic_inlined"};
  request["verification"]["acceleration"] = 1;
  expect_row(table_of(json), row,
             {{"CPU s", failed_mark}, {"remark", "acceleration differs by 1, 1e-07 is allowed"}});
  json["record"]["settings"].erase("allowed");
  EXPECT_TRUE(entry_at(table_of(json), row, "CPU s").has_number());
}

TEST(Requests, HaveNoRatioWithoutEverything) {
  Json json = requests_record();
  fail_candidate(json, 225, "block_symbolic_inlined");
  erase_candidate(json, 225, "global_automatic_klu");
  const Table table = table_of(json);
  expect_row(table, {wheel, "position", "block_symbolic_inlined"},
             {{"times cheaper", "reference FAILED"}});
  expect_row(table, {wheel, "position", "global_automatic_klu"},
             {{"times cheaper", "reference —"}});
  expect_row(table, {"everything", "acceleration", "block_symbolic_inlined"},
             {{"CPU s", failed_mark}});
}

TEST(Requests, AreCheckedWhenRead) {
  const Json json = requests_record();
  const std::string checked = "/paper/requests/5/verification";
  expect_refusals(
      json, {{"/paper/requests/0/level", "jerk", ": \"jerk\" is none of"},
             {"/paper/requests/0/unknowns", 219, ": more unknowns than"},
             {"/paper/requests/0/request", "../x", ": "},
             {checked + "/acceleration", removed, checked + ": the key 'acceleration' is missing"},
             {"/paper/requests/0/verification", removed, "'verification' is missing"},
             {"/paper/requests/-", json["paper"]["requests"][2],
              "/paper/requests/6: the request wheel_centre of block_symbolic_inlined is given "
              "twice"}});
}

}  // namespace
}  // namespace desmo::report::requests_test
