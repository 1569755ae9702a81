#include "tests/report/check/check_sample.h"

namespace desmo::report {
namespace {

constexpr int rounds = 25;

/// Seconds near `middle`, up to 0.4 % off: a walk through all residues, another for each side.
Json times(double middle, int stride) {
  Json seconds = Json::array();
  for (int round = 0; round < rounds; ++round)
    seconds.push_back(middle * (1 + 0.0003 * (round * stride % rounds - rounds / 2)));
  return seconds;
}

/// The environment and three candidates of a recorded run, with made-up times.
Json side(int stride) {
  Json record = origins_record();
  record["record"]["settings"].erase("windows");
  for (const char* list : {"profiles", "structure", "requests"}) record["paper"].erase(list);
  Json candidates = Json::array();
  double middle = 0.001;
  for (const Json& candidate : record["paper"]["candidates"]) {
    const std::string id = candidate["id"];
    const bool wanted = candidate["case"] == truck && candidate["coordinates"] == 114 &&
                        (id == "global_automatic_klu" || id == "group_symbolic_klu" ||
                         id == "group_symbolic_inlined");
    if (!wanted) continue;
    candidates.push_back(candidate);
    candidates.back()["time"] = {{"clock", "cpu"}, {"seconds", times(middle *= 0.7, stride)}};
  }
  record["paper"]["candidates"] = candidates;
  return record;
}

Json& candidate_named(Json& record, const std::string& name) {
  return candidate_of(record, 114, name.substr(name.rfind('/') + 1));
}

}  // namespace

Json check_sample() {
  Json check = {{"schema", "desmo-check"}, {"schema_version", schema_version}};
  check["settings"] = {{"seed", 1}, {"turns", 3}, {"repetitions", 2}};
  check["base"] = side(7);
  check["head"] = side(11);
  check["control"] = {{"base", times(1e-4, 7)}, {"head", times(1e-4, 11)}};
  check["work"] = {{"tool", "valgrind-3.19.0"}, {"steps", 100}, {"iterations", 3}};
  for (const Json& candidate : check["head"]["paper"]["candidates"])
    check["work"]["instructions"]["truck_suspension/114/" + candidate["id"].get<std::string>()] = {
        {"base", 1'000'000}, {"head", 1'000'000}};
  return check;
}

Json one_tree_sample() {
  Json check = check_sample();
  take_no_times(check);
  check.erase("base");
  for (Json& counts : check["work"]["instructions"]) counts.erase("base");
  return check;
}

void slow_down(Json& check, const std::string& candidate, double factor) {
  for (Json& seconds : candidate_named(check["head"], candidate)["time"]["seconds"])
    seconds = seconds.get<double>() * factor;
}

void confirm(Json& check, const std::string& candidate, double factor) {
  check["second"][candidate] = {{"base", times(1e-3, 7)}, {"head", times(1e-3 * factor, 11)}};
  check["second"]["control"] = check["control"];
}

void fail_head(Json& check, const std::string& name) { fail(candidate_named(check["head"], name)); }

void leave_out(Json& check, const std::string& side, const std::string& name) {
  Json& candidate = candidate_named(check[side], name);
  candidate = {{"case", candidate["case"]},
               {"coordinates", candidate["coordinates"]},
               {"id", candidate["id"]},
               {"status", "not_run"},
               {"message", "unknown"}};
}

void take_no_times(Json& check) {
  check.erase("control");
  for (const char* side : {"base", "head"})
    for (Json& candidate : check[side]["paper"]["candidates"]) {
      candidate["status"] = "not_run";
      candidate["message"] = "verified, not timed";
      candidate.erase("time");
    }
}

CheckRecord check_from(const Json& json) { return parse_check(json.dump()); }

}  // namespace desmo::report
