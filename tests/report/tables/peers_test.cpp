#include "report/formats/formats.h"
#include "tests/report/sample.h"

namespace desmo::report::peers_test {
namespace {

Json peer(int coordinates, const std::string& name, std::vector<double> seconds) {
  return {{"case", truck},
          {"coordinates", coordinates},
          {"peer", name},
          {"library", "Library of " + name},
          {"library_version", "1.2"},
          {"method", "as its manual has it"},
          {"guess", "quadratic"},
          {"status", "ok"},
          {"verification", levels(2e-11, 3e-11, 4e-10)},
          {"time", {{"clock", "cpu"}, {"seconds", seconds}}},
          {"iterations_per_step", 1.01}};
}

Json left_out(int coordinates, const std::string& name) {
  Json json = peer(coordinates, name, {});
  for (const char* key : {"verification", "time", "iterations_per_step"}) json.erase(key);
  json["status"] = "not_run";
  json["message"] = "it would take too long";
  return json;
}

/// Two peers beside two of ours, which start from the same guess. Made-up numbers.
Json peers_record() {
  Json json = requests_record();
  for (const auto& [id, seconds] :
       {std::pair{"global_automatic_klu", 0.03}, {"block_symbolic_inlined", 0.003}}) {
    Json candidate = candidate_of(json, 114, "global_automatic_klu");
    candidate["id"] = std::string(id) + "/guess:quadratic";
    candidate["time"]["seconds"] = {seconds * 0.99, seconds, seconds * 1.01};
    candidate["iterations_per_step"] = 2.0;
    json["paper"]["candidates"].push_back(candidate);
  }
  json["paper"]["peers"] = {peer(114, "slow", {0.59, 0.6, 0.61}), peer(114, "quick", {0.0015}),
                            left_out(225, "slow")};
  return json;
}

Table times(const Json& json) { return table_of(json, "peers_truck_suspension"); }

TEST(Peers, AreMeasuredAgainstOursWithTheSameGuess) {
  const Table table = times(peers_record());
  const std::vector<std::string> slow{"114", "slow"};
  expect_row(table, slow,
             {{"CPU s", "0.6000 ±0.0100"},
              {"µs/step", "199.9"},
              {"times ours, global", "20.00 [19.47, 20.54]"},
              {"iterations/step", "1.01"},
              {"error q''", "4.0e-10"}});
  EXPECT_EQ(entry_at(table, slow, "times ours, fastest").digits,
            (std::vector<std::string>{"200", "195", "205"}));
  expect_row(table, {"114", "quick"}, {{"times ours, fastest", "0.5"}});
  expect_row(table, {"114", "global_automatic_klu/guess:quadratic"},
             {{"times ours, global", "1.00 reference"}, {"times ours, fastest", "10.00 …"}});
  expect_row(table, {"114", "block_symbolic_inlined/guess:quadratic"},
             {{"times ours, fastest", "1.00 reference"}});
}

TEST(Peers, BeginWithTheFastestAndTheSlowest) {
  Json json = peers_record();
  const auto found = [&] { return peers(record_from(json)).paragraphs; };
  EXPECT_EQ(found(), (std::vector<std::string>{
                         "On truck_suspension with 114 coordinates, from the same guess, the "
                         "fastest peer (quick) takes 0.5 times as long as our fastest formulation, "
                         "the slowest (slow) 200 times."}));
  json["paper"]["peers"].erase(1);
  EXPECT_TRUE(found().at(0).ends_with(
      "the fastest peer (slow) takes 200 times as long as our fastest formulation."))
      << found().at(0);
  json["paper"]["peers"][0]["guess"] = "previous";
  EXPECT_EQ(found(), (std::vector<std::string>{
                         "No peer has a time next to a formulation of ours with the same guess."}));
  json["paper"].erase("peers");
  EXPECT_TRUE(found().empty());
}

TEST(Peers, WithoutOursOfTheirGuessHaveNoRatio) {
  Json json = peers_record();
  erase_candidate(json, 114, "global_automatic_klu/guess:quadratic");
  const std::vector<std::string> slow{"114", "slow"};
  expect_row(times(json), slow,
             {{"times ours, global", missing_mark}, {"times ours, fastest", "200 …"}});
  json["paper"]["peers"][0]["guess"] = "previous";
  expect_row(times(json), slow, {{"times ours, fastest", missing_mark}});
}

TEST(Peers, ThatFailedOrDidNotRunHaveNoTime) {
  Json json = peers_record();
  json["paper"]["peers"][0]["verification"]["velocity"] = 2e-8;  // more than is allowed
  expect_row(times(json), {"225", "slow"},
             {{"CPU s", not_run_mark},
              {"times ours, fastest", missing_mark},
              {"remark", "it would take too long"}});
  expect_row(times(json), {"114", "slow"},
             {{"CPU s", failed_mark}, {"times ours, fastest", failed_mark}});
  EXPECT_TRUE(says(make_report(record_from(json)).sections.back().paragraphs,
                   "FAILED: truck_suspension/114/peer:slow: velocity differs by 2e-08, 1e-08 is "
                   "allowed"));
}

TEST(Peers, LeaveThePapersTablesAsTheyAre) {
  const Document a = make_report(record_from(peers_record())),
                 b = make_report(record_from(requests_record()));
  for (const Table& table : tables_of(b))
    EXPECT_EQ(to_csv(table_named(a, table.name)), to_csv(table)) << table.name;
  EXPECT_EQ(a.sections.size(), b.sections.size() + 1);
}

TEST(Peers, AreReadWithCare) {
  Json json = peers_record();
  json["paper"]["peers"][0]["model"] = std::string(64, 'a');
  expect_refusals(
      json,
      {{"/paper/peers/0/machine", "another CPU", "truck_suspension/114/peer:slow: measured on"},
       {"/paper/peers/1/model", std::string(64, 'b'), "peer:quick: solves another model"},
       {"/paper/peers/1/peer", "slow",
        "/paper/peers/1: truck_suspension/114/peer:slow is given twice"},
       {"/paper/peers/0/guess", "../x", ": "}});
}

}  // namespace
}  // namespace desmo::report::peers_test
