#include "bench/kit/record/record.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "bench/experiments/paper/case_candidate.h"
#include "bench/experiments/paper/peer_candidate.h"
#include "bench/experiments/paper/request.h"
#include "bench/kit/record/environment.h"
#include "bench/kit/record/environment_json.h"
#include "bench/kit/record/record_layout.h"
#include "bench/kit/record/time_json.h"
#include "bench/kit/structure.h"
#include "formulations/prediction/guess.h"

namespace desmo::bench {

namespace {

using Json = nlohmann::ordered_json;
using namespace paper;

constexpr std::array level_names{"position", "velocity", "acceleration"};

/// Status, the message unless it is "ok", and what was solved, where, with which results: of what
/// has no time, nothing that follows is written.
void add_status(Json& j, const Candidate& timed) {
  j["status"] = timed.is_timed() ? "ok" : timed.is_not_run() ? "not_run" : "failed";
  if (!timed.is_timed()) j["message"] = timed.message.empty() ? "not timed" : timed.message;
  if (timed.is_not_run()) return;
  j["machine"] = this_machine().cpu;
  if (!timed.model.empty()) j["model"] = timed.model;
  if (!timed.results.empty()) j["results"] = timed.results;
}

/// Of what has a time: how right it is, the time, and what belongs to it.
void add_time(Json& j, const Candidate& timed, Json verification) {
  j["verification"] = std::move(verification);
  if (timed.threads > 1) j["threads"] = timed.threads;
  j["time"] = time_json(timed.seconds, timed.clock);
  if (timed.clock == Clock::cpu) j["time"]["windows"] = windows_json(timed.windows);
  j["setup_time"] = time_json({timed.setup_seconds});
  j["iterations_per_step"] = timed.iterations_per_step;
}

Json cell_json(const CaseCandidate& cell) {
  Json j = {{"case", cell.definition.name}, {"coordinates", cell.coordinates}, {"id", cell.id()}};
  if (!cell.is_not_run()) {
    j["groups"] = cell.groups;
    j["degrees_of_freedom"] = cell.degrees_of_freedom;
  }
  add_status(j, cell);
  if (!cell.is_timed()) return j;
  add_time(j, cell, errors_json(cell.errors));
  j["residual"] = cell.residual;
  return j;
}

/// Levels that were not asked were not compared.
Json errors_json(const Errors& errors, Level level) {
  Json j = errors_json(errors);
  if (level < Level::velocity) j.erase("velocity");
  if (level < Level::acceleration) j.erase("acceleration");
  return j;
}

Json request_json(const RequestCandidate& cell) {
  const PlannedRequest& request = cell.request();
  Json j = {{"case", request.definition.name},
            {"coordinates", request.whole.coordinates()},
            {"id", cell.id()},
            {"request", request.name},
            {"title", request.title},
            {"level", level_names[static_cast<int>(request.plan.level())]},
            {"unknowns", request.unknowns},
            {"all_unknowns", request.all_unknowns}};
  add_status(j, cell);
  if (!cell.is_timed()) return j;
  j["difference"] = cell.difference;
  add_time(j, cell, errors_json(cell.errors, request.plan.level()));
  j["residual"] = cell.residual;
  return j;
}

Json peer_json(const PeerCandidate& cell) {
  Json j = {{"case", cell.definition.name},
            {"coordinates", cell.coordinates},
            {"peer", cell.peer.name},
            {"library", cell.peer.library},
            {"library_version", cell.peer.version()},
            {"method", cell.peer.method},
            {"guess", guess_name(cell.peer.guess)}};
  if (!cell.setup.empty()) {
    j["setup"] = cell.setup;
    j["compared"] = cell.compared;
  }
  add_status(j, cell);
  if (!cell.is_timed()) return j;
  add_time(j, cell, errors_json(cell.errors));
  return j;
}

Json structure_json(const Structure& structure) {
  const Case& definition = *structure.definition;
  Json parts = Json::array();
  for (const PartSizes& p : structure.parts)
    parts.push_back({{"unknowns", p.unknowns}, {"count", p.count}});
  return {{"case", definition.name},
          {"coordinates", structure.coordinates},
          {"partition", structure.partition},
          {"unit", definition.unit_name},
          {"units",
           (structure.coordinates - definition.base_coordinates) / definition.coordinates_per_unit},
          {"parts", parts}};
}

Json profile_json(const CaseCandidate& cell) {
  Json seconds;
  for (int p = 0; p < phase_count; ++p) seconds[phase_names[p]] = cell.phases->seconds[p];
  seconds["rest"] = cell.phases->rest;
  return {{"case", cell.definition.name},
          {"coordinates", cell.coordinates},
          {"id", cell.id()},
          {"time_per_step",
           {{"clock", clock_name(Clock::wall)},
            {"phases", seconds},
            {"total_range", {cell.phases->min_total, cell.phases->max_total}}}}};
}

/// Each list stands in the section of its experiment.
constexpr std::array<std::pair<const char*, const char*>, 13> sections{{{"cells", "paper"},
                                                                        {"requests", "paper"},
                                                                        {"peers", "paper"},
                                                                        {"structure", "paper"},
                                                                        {"profiles", "paper"},
                                                                        {"floors", "accuracy"},
                                                                        {"points", "accuracy"},
                                                                        {"tuning", "accuracy"},
                                                                        {"growth", "size"},
                                                                        {"break_even", "size"},
                                                                        {"counts", "instructions"},
                                                                        {"rows", "extremes"},
                                                                        {"results", "extremes"}}};

Json by_experiment(const Json& lists) {
  Json all = Json::object();
  for (const auto& [name, list] : lists.items()) {
    const auto place =
        std::ranges::find(sections, name, &std::pair<const char*, const char*>::first);
    if (place == sections.end()) throw std::logic_error("a record has no list " + name);
    if (!list.empty()) all[place->second][name] = list;
  }
  return all;
}

}  // namespace

std::string record_text(const Run& run, const TimeGrid& grid, const Json& lists,
                        std::optional<int> windows) {
  Json head{{"schema", "desmo-results"},
            {"schema_version", schema_version},
            {"record", environment_json(run, grid)}};
  if (windows) head["record"]["settings"]["windows"] = *windows;
  return record_layout(head, by_experiment(lists));
}

std::string command_line(int argc, char** argv) {
  std::string command = std::filesystem::path(argv[0]).filename().string();
  for (int i = 1; i < argc; ++i) command += std::string(" ") + argv[i];
  return command;
}

Json lists_of(const std::vector<Candidate*>& timed) {
  Json all;
  for (const char* list : {"cells", "profiles", "structure", "requests"}) all[list] = Json::array();
  std::set<std::pair<std::string_view, int>> described;
  for (const Candidate* one : timed) {
    if (const auto* request = dynamic_cast<const RequestCandidate*>(one))
      all["requests"].push_back(request_json(*request));
    if (const auto* peer = dynamic_cast<const PeerCandidate*>(one))
      all["peers"].push_back(peer_json(*peer));
    const auto* cell = dynamic_cast<const CaseCandidate*>(one);
    if (!cell) continue;
    all["cells"].push_back(cell_json(*cell));
    if (cell->phases && cell->state == Candidate::State::verified)
      all["profiles"].push_back(profile_json(*cell));
    if (described.emplace(cell->definition.name, cell->coordinates).second)
      for (const Structure& structure : structures(cell->definition, cell->coordinates))
        all["structure"].push_back(structure_json(structure));
  }
  return all;
}

}  // namespace desmo::bench
