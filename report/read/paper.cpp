// The paper's experiment: candidates, requests and peers; structure and profiles.
#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "report/read/readers.h"

namespace desmo::report {
namespace {

// Of the CPU clock, like everything that is done once.
std::optional<double> read_setup(const RecordValue& node) {
  const auto time = node.find("setup_time");
  if (!time) return std::nullopt;
  require_clock(*time, Clock::cpu, "a set-up");
  const RecordValue seconds = (*time)["seconds"];
  const std::vector<RecordValue> samples = seconds.elements();
  if (samples.size() != 1) seconds.complain("one sample was expected");
  return samples.front().not_negative();
}

std::vector<Solver> read_solvers(const RecordValue& node) {
  std::vector<Solver> solvers;
  if (const auto list = node.find("solvers"))
    for (const RecordValue& solver : list->elements()) {
      const RecordValue unknowns = solver["unknowns"];
      const std::vector<RecordValue> range = unknowns.elements();
      if (range.size() != 2) unknowns.complain("the least and the most were expected");
      solvers.push_back({solver["algebra"].text(),
                         solver["parts"].integer(1),
                         {range[0].integer(1), range[1].integer(1)}});
    }
  return solvers;
}

void turn_into_failure(Candidate& candidate, std::string reason) {
  if (reason.empty()) return;
  candidate.status = Status::failed;
  candidate.message = std::move(reason);
  candidate.time = {};
}

/// Reads what requests have, too. Times of a wrong answer are not times.
Candidate read_solved(const RecordValue& node, const Settings& settings, std::string_view id) {
  Candidate candidate{
      .status = read_status(node["status"]),
      .message = node.find_text("message").value_or(""),
      .origin = {node.find_text("machine"), node.find_digest("model"), node.find_digest("results")},
      .time = {},
      .verification = std::nullopt,
      .setup_seconds = std::nullopt,
      .iterations_per_step = node.find_number("iterations_per_step"),
      .solvers = {}};
  if (candidate.status == Status::ok) candidate.time = read_time(node["time"], settings, id);
  return candidate;
}

Candidate read_candidate(const RecordValue& node, const Settings& settings, std::string_view id) {
  Candidate candidate = read_solved(node, settings, id);
  candidate.setup_seconds = read_setup(node);
  candidate.solvers = read_solvers(node);
  if (const auto checked = node.find("verification"))
    candidate.verification = read_verification(*checked);
  if (candidate.status != Status::ok) return candidate;
  if (!candidate.verification) node.complain("an \"ok\" cell needs \"verification\"");
  if (settings.allowed)
    turn_into_failure(candidate, excess(*candidate.verification, *settings.allowed));
  return candidate;
}

// Only the levels asked were compared.
std::string request_excess(const RecordValue& verification, double difference,
                           const Allowed& allowed) {
  Verification found{.instants = verification["instants"].integer(1),
                     .position = verification["position"].not_negative()};
  found.velocity = verification.find_number("velocity").value_or(0);
  found.acceleration = verification.find_number("acceleration").value_or(0);
  std::string reason = excess(found, allowed);
  if (reason.empty() && allowed.request)
    reason = excess("the answer beside the whole mechanism's", difference, *allowed.request);
  return reason;
}

Request read_request(const RecordValue& node, const Settings& settings) {
  const CandidateKey key = read_key(node);
  const RecordValue level = node["level"];
  level.one_of({"position", "velocity", "acceleration"});
  Request request{.key = key,
                  .name = node["request"].name(),
                  .title = node["title"].text(),
                  .level = level.text(),
                  .unknowns = node["unknowns"].integer(1),
                  .all_unknowns = node["all_unknowns"].integer(1),
                  .solved = read_solved(node, settings, key.id),
                  .difference = node.find_number("difference")};
  if (request.unknowns > request.all_unknowns)
    node["unknowns"].complain("more unknowns than the whole mechanism has");
  if (request.solved.status != Status::ok) return request;
  const RecordValue verification = node["verification"];
  if (!request.difference) node.complain("an \"ok\" request needs \"difference\"");
  if (settings.allowed)
    turn_into_failure(request.solved,
                      request_excess(verification, *request.difference, *settings.allowed));
  return request;
}

Peer read_peer(const RecordValue& node, const Settings& settings) {
  return {.case_name = node["case"].name(),
          .coordinates = node["coordinates"].integer(1),
          .name = node["peer"].name(),
          .library = node["library"].text(),
          .library_version = node["library_version"].text(),
          .method = node["method"].text(),
          .guess = node["guess"].name(),
          .solved = read_candidate(node, settings, "a peer")};
}

Profile read_profile(const RecordValue& node) {
  Profile profile;
  const RecordValue time = node["time_per_step"], split = time["phases"];
  require_clock(time, Clock::wall, "a profile");
  for (std::size_t i = 0; i < phases.size(); ++i)
    profile[i] = split[phases[i]].not_negative();
  return profile;
}

}  // namespace

CandidateKey read_key(const RecordValue& node) {
  return {node["case"].name(), node["coordinates"].integer(1), node["id"].text()};
}

void read_paper(Record& record, const RecordValue& experiment) {
  const Settings& settings = record.settings;
  read_each(experiment, "cells", [&](const RecordValue& node) {
    const CandidateKey key = read_key(node);
    add_once(is_by_wall(key.id) ? record.wall_candidates : record.candidates, node, key,
             read_candidate(node, settings, key.id), name_of(key));
  });
  std::set<std::pair<CandidateKey, std::string>> seen;
  read_each(experiment, "requests", [&](const RecordValue& node) {
    Request request = read_request(node, settings);
    if (!seen.emplace(request.key, request.name).second)
      node.complain("the request " + request.name + " of " + request.key.id + " is given twice");
    (is_by_wall(request.key.id) ? record.wall_requests : record.requests)
        .push_back(std::move(request));
  });
  read_each(experiment, "peers", [&](const RecordValue& node) {
    record.peers.push_back(read_peer(node, settings));
    const CandidateKey key = key_of(record.peers.back());
    if (std::ranges::count(record.peers, key, key_of) > 1)
      node.complain(name_of(key) + " is given twice");
  });
  read_each(experiment, "profiles", [&](const RecordValue& node) {
    const CandidateKey key = read_key(node);
    add_once(record.profiles, node, key, read_profile(node), name_of(key));
  });
}

}  // namespace desmo::report
