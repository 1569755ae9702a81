#include "bench/experiments/paper/record.h"

#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>

#include "bench/experiments/paper/case_candidate.h"
#include "bench/experiments/paper/peer_candidate.h"
#include "bench/experiments/paper/request.h"
#include "bench/kit/problem.h"
#include "bench/kit/record/environment.h"
#include "bench/kit/record/record.h"
#include "formulations/prediction/guess.h"

namespace desmo::paper {

namespace {

using Json = nlohmann::ordered_json;

/// Completes an entry: status, the message unless it is "ok", what was solved, where, with which
/// results, how right it is, the time, and what belongs to it. A candidate without a time has less.
Json with_measurement(Json j, const Candidate& c, Level level = Level::acceleration) {
  j["status"] = c.is_timed() ? "ok" : c.is_not_run() ? "not_run" : "failed";
  if (!c.is_timed()) j["message"] = c.message.empty() ? "not timed" : c.message;
  if (c.is_not_run()) return j;
  j["machine"] = processor_name();
  if (!c.model.empty()) j["model"] = c.model;
  if (!c.results.empty()) j["results"] = c.results;
  if (!c.is_timed()) return j;
  if (const auto* request = dynamic_cast<const RequestCandidate*>(&c))
    j["difference"] = request->difference;
  j["verification"] = errors_json(c.errors, level);
  if (c.threads > 1) j["threads"] = c.threads;
  j["time"] = time_json(c.seconds, c.clock);
  if (c.clock == Clock::cpu) j["time"]["windows"] = windows_json(c.windows);
  j["setup_time"] = time_json({c.setup_seconds});
  j["iterations_per_step"] = c.iterations_per_step;
  if (!dynamic_cast<const PeerCandidate*>(&c)) j["residual"] = c.residual;
  return j;
}

Json case_json(const CaseCandidate& c) {
  Json j = {{"case", c.definition.name}, {"coordinates", c.coordinates}, {"id", c.id()}};
  if (!c.is_not_run()) {
    j["groups"] = c.groups;
    j["degrees_of_freedom"] = c.degrees_of_freedom;
  }
  return with_measurement(std::move(j), c);
}

Json request_json(const RequestCandidate& c) {
  const PlannedRequest& request = c.request();
  const Level level = request.plan.level();
  return with_measurement({{"case", request.definition.name},
                           {"coordinates", request.whole.coordinates()},
                           {"id", c.id()},
                           {"request", request.name},
                           {"title", request.title},
                           {"level", level_names[level]},
                           {"unknowns", request.unknowns},
                           {"all_unknowns", request.all_unknowns}},
                          c, level);
}

Json peer_json(const PeerCandidate& c) {
  Json j = {{"case", c.definition.name},
            {"coordinates", c.coordinates},
            {"peer", c.peer.name},
            {"library", c.peer.library},
            {"library_version", c.peer.version()},
            {"method", c.peer.method},
            {"guess", guess_name(c.peer.guess)}};
  if (!c.setup.empty()) {
    j["setup"] = c.setup;
    j["compared"] = c.compared;
  }
  return with_measurement(std::move(j), c);
}

Json structure_json(const CaseStructure& structure) {
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

Json profile_json(const CaseCandidate& c) {
  Json seconds;
  for (int p = 0; p < phase_count; ++p) seconds[phase_names[p]] = c.phases->seconds[p];
  seconds["rest"] = c.phases->rest;
  return {{"case", c.definition.name},
          {"coordinates", c.coordinates},
          {"id", c.id()},
          {"time_per_step",
           {{"clock", clock_name(Clock::wall)},
            {"phases", seconds},
            {"total_range", {c.phases->min_total, c.phases->max_total}}}}};
}

}  // namespace

Json lists_of(const std::vector<Candidate*>& candidates) {
  Json all;
  for (const char* list : {"cells", "profiles", "structure", "requests"}) all[list] = Json::array();
  std::set<std::pair<std::string_view, int>> described;
  for (const Candidate* one : candidates) {
    if (const auto* request = dynamic_cast<const RequestCandidate*>(one))
      all["requests"].push_back(request_json(*request));
    if (const auto* peer = dynamic_cast<const PeerCandidate*>(one))
      all["peers"].push_back(peer_json(*peer));
    const auto* c = dynamic_cast<const CaseCandidate*>(one);
    if (!c) continue;
    all["cells"].push_back(case_json(*c));
    if (c->phases && c->is_verified()) all["profiles"].push_back(profile_json(*c));
    if (described.emplace(c->definition.name, c->coordinates).second)
      for (const CaseStructure& structure : structures(c->definition, c->coordinates))
        all["structure"].push_back(structure_json(structure));
  }
  return all;
}

}  // namespace desmo::paper
