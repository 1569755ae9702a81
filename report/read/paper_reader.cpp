#include "report/read/paper_reader.h"

#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "report/read/time_reader.h"
#include "report/read/verification_reader.h"

namespace desmo::report {
namespace {

Origin read_origin(const JsonNode& node) {
  return {node.find_text("machine"), node.find_digest("model"), node.find_digest("results")};
}

std::optional<double> read_optional(const JsonNode& node, std::string_view key) {
  const auto member = node.find(key);
  return member ? std::optional(member->not_negative()) : std::nullopt;
}

std::int64_t read_threads(const JsonNode& node) {
  const auto threads = node.find("threads");
  return threads ? threads->integer(2) : 1;
}

// Of the CPU clock, like everything that is done once.
std::optional<double> read_setup(const JsonNode& node) {
  const auto time = node.find("setup_time");
  if (!time) return std::nullopt;
  if (read_clock((*time)["clock"]) != Clock::cpu)
    (*time)["clock"].complain("a set-up is measured by \"cpu\"");
  const JsonNode seconds = (*time)["seconds"];
  const std::vector<JsonNode> samples = seconds.elements();
  if (samples.size() != 1) seconds.complain("one sample was expected");
  return samples.front().not_negative();
}

std::vector<Solver> read_solvers(const JsonNode& node) {
  std::vector<Solver> solvers;
  if (const auto list = node.find("solvers"))
    for (const JsonNode& solver : list->elements()) {
      const JsonNode unknowns = solver["unknowns"];
      const std::vector<JsonNode> range = unknowns.elements();
      if (range.size() != 2) unknowns.complain("the least and the most were expected");
      solvers.push_back({solver["algebra"].text(),
                         solver["parts"].integer(1),
                         {range[0].integer(1), range[1].integer(1)}});
    }
  return solvers;
}

template <class Timed>
void turn_into_failure(Timed& timed, std::string reason) {
  timed.status = Status::failed;
  timed.message = std::move(reason);
  timed.time = {};
}

Candidate read_candidate(const JsonNode& node, const Settings& settings, std::string_view id) {
  Candidate candidate{.status = read_status(node["status"]),
                      .message = node.find_text("message").value_or(""),
                      .origin = read_origin(node),
                      .time = {},
                      .threads = read_threads(node),
                      .verification = std::nullopt,
                      .setup_seconds = read_setup(node),
                      .iterations_per_step = read_optional(node, "iterations_per_step"),
                      .residual = read_optional(node, "residual"),
                      .solvers = read_solvers(node)};
  if (const auto checked = node.find("verification"))
    candidate.verification = read_verification(*checked);
  if (candidate.status != Status::ok) return candidate;  // times of a wrong answer are not times
  if (!candidate.verification) node.complain("an \"ok\" cell needs \"verification\"");
  candidate.time = read_time(node["time"], settings, id);
  if (!settings.allowed) return candidate;
  if (std::string reason = excess(*candidate.verification, *settings.allowed); !reason.empty())
    turn_into_failure(candidate, std::move(reason));
  return candidate;
}

std::string read_level(const JsonNode& node) {
  const std::string level = node.text();
  if (level != "position" && level != "velocity" && level != "acceleration")
    node.complain("\"" + level + "\" is none of \"position\", \"velocity\", \"acceleration\"");
  return level;
}

// Only the levels asked were compared.
std::string request_excess(const JsonNode& verification, double difference,
                           const Allowed& allowed) {
  Verification found{.instants = verification["instants"].integer(1),
                     .position = verification["position"].not_negative()};
  found.velocity = read_optional(verification, "velocity").value_or(0);
  found.acceleration = read_optional(verification, "acceleration").value_or(0);
  std::string reason = excess(found, allowed);
  if (reason.empty() && allowed.request)
    reason = excess("the answer beside the whole mechanism's", difference, *allowed.request);
  return reason;
}

Request read_request(const JsonNode& node, const Settings& settings) {
  Request request{.candidate = read_key(node),
                  .name = node["request"].name(),
                  .title = node["title"].text(),
                  .level = read_level(node["level"]),
                  .unknowns = node["unknowns"].integer(1),
                  .all_unknowns = node["all_unknowns"].integer(1),
                  .status = read_status(node["status"]),
                  .message = node.find_text("message").value_or(""),
                  .origin = read_origin(node),
                  .time = {},
                  .threads = read_threads(node),
                  .difference = read_optional(node, "difference"),
                  .iterations_per_step = read_optional(node, "iterations_per_step")};
  if (request.unknowns > request.all_unknowns)
    node["unknowns"].complain("more unknowns than the whole mechanism has");
  if (request.status != Status::ok) return request;  // times of a wrong answer are not times
  const JsonNode verification = node["verification"];
  if (!request.difference) node.complain("an \"ok\" request needs \"difference\"");
  request.time = read_time(node["time"], settings, request.candidate.id);
  if (!settings.allowed) return request;
  if (std::string reason = request_excess(verification, *request.difference, *settings.allowed);
      !reason.empty())
    turn_into_failure(request, std::move(reason));
  return request;
}

Peer read_peer(const JsonNode& node, const Settings& settings) {
  Peer peer{.case_name = node["case"].name(),
            .coordinates = node["coordinates"].integer(1),
            .name = node["peer"].name(),
            .library = node["library"].text(),
            .library_version = node["library_version"].text(),
            .method = node["method"].text(),
            .guess = node["guess"].name(),
            .setup = node.find_text("setup").value_or(""),
            .compared = std::nullopt,
            .candidate = read_candidate(node, settings, "a peer")};
  if (const auto compared = node.find("compared")) peer.compared = compared->integer(1);
  if (peer.compared && *peer.compared > peer.coordinates)
    node["compared"].complain("more coordinates than the mechanism has");
  return peer;
}

void read_candidates(Record& record, const JsonNode& list) {
  for (const JsonNode& node : list.elements()) {
    const CandidateKey key = read_key(node);
    auto& candidates = is_by_wall(key.id) ? record.wall_candidates : record.candidates;
    if (!candidates.emplace(key, read_candidate(node, record.settings, key.id)).second)
      node.complain(name_of(key) + " is given twice");
  }
}

void read_requests(Record& record, const JsonNode& list) {
  std::set<std::pair<CandidateKey, std::string>> seen;
  for (const JsonNode& node : list.elements()) {
    Request request = read_request(node, record.settings);
    if (!seen.emplace(request.candidate, request.name).second)
      node.complain("the request " + request.name + " of " + request.candidate.id +
                    " is given twice");
    (is_by_wall(request.candidate.id) ? record.wall_requests : record.requests)
        .push_back(std::move(request));
  }
}

void read_peers(Record& record, const JsonNode& list) {
  std::set<std::tuple<std::string, std::int64_t, std::string>> seen;
  for (const JsonNode& node : list.elements()) {
    record.peers.push_back(read_peer(node, record.settings));
    const Peer& peer = record.peers.back();
    if (!seen.emplace(peer.case_name, peer.coordinates, peer.name).second)
      node.complain(name_of(key_of(peer)) + " is given twice");
  }
}

}  // namespace

CandidateKey read_key(const JsonNode& node) {
  return {node["case"].name(), node["coordinates"].integer(1), node["id"].text()};
}

void read_paper(Record& record, const JsonNode& section) {
  if (const auto candidates = section.find("cells")) read_candidates(record, *candidates);
  if (const auto requests = section.find("requests")) read_requests(record, *requests);
  if (const auto peers = section.find("peers")) read_peers(record, *peers);
  read_structures(record, section);
  read_profiles(record, section);
}

}  // namespace desmo::report
