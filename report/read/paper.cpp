// The paper's experiment: candidates, requests, peers and profiles.
#include <algorithm>
#include <regex>
#include <set>
#include <string_view>
#include <utility>

#include "report/read/readers.h"

namespace desmo::report {
namespace {

// Reads the time of a set-up, which is done once and measured by the CPU clock [s].
double read_setup(const RecordValue& time) {
  require_clock(time, Clock::cpu, "a set-up");
  const std::vector<double> samples = time["seconds"].list(&RecordValue::not_negative);
  if (samples.size() != 1) time["seconds"].complain("one sample was expected");
  return samples.front();
}

/// Reads what candidates and requests have in common. A time is read only where the status is ok.
Measurement read_solved(const RecordValue& node, const RecordSettings& settings,
                        std::string_view id) {
  Measurement candidate{
      .status = read_status(node["status"]),
      .message = node.maybe("message", &RecordValue::text).value_or(""),
      .origin = {node.maybe("machine", &RecordValue::text),
                 node.maybe("model", &RecordValue::digest),
                 node.maybe("results", &RecordValue::digest)},
      .iterations_per_step = node.maybe("iterations_per_step", &RecordValue::not_negative)};
  if (candidate.status == Status::ok) candidate.time = read_time(node["time"], settings, id);
  return candidate;
}

Measurement read_candidate(const RecordValue& node, const RecordSettings& settings,
                           std::string_view id) {
  Measurement candidate = read_solved(node, settings, id);
  candidate.setup_seconds = node.maybe("setup_time", read_setup);
  if (const auto checked = node.find("verification"))
    candidate.verification = read_levels(*checked, &RecordValue::not_negative);
  if (candidate.status != Status::ok) return candidate;
  if (!candidate.verification) node.complain("an \"ok\" candidate needs \"verification\"");
  if (settings.allowed) fail(candidate, excess(*candidate.verification, *settings.allowed));
  return candidate;
}

/// Reads the key of a candidate or request. Its id has the number of threads, which the table of
/// threads shows.
CandidateKey read_timed_key(const RecordValue& node) {
  static const std::regex no_number("/threads:(?![1-9][0-9]{0,8}(/|$))");
  CandidateKey key = read_key(node);
  if (std::regex_search(key.id, no_number))
    node["id"].complain(in_double_quotes(key.id) + " has no number of threads");
  return key;
}

MeasuredRequest read_request(const RecordValue& node, const RecordSettings& settings) {
  const CandidateKey key = read_timed_key(node);
  const RecordValue level = node["level"];
  const std::size_t highest = level.one_of({"position", "velocity", "acceleration"});
  MeasuredRequest request{read_solved(node, settings, key.id),
                          key,
                          node["request"].name(),
                          node["title"].text(),
                          level.text(),
                          node["unknowns"].integer(1),
                          node["all_unknowns"].integer(1)};
  if (request.unknowns > request.all_unknowns)
    node["unknowns"].complain("more unknowns than the whole mechanism has");
  if (request.status != Status::ok) return request;
  const RecordValue verification = node["verification"];
  if (!settings.allowed) return request;
  const auto difference = [&](const char* name, std::size_t of_level) {
    return of_level <= highest ? verification[name].not_negative() : 0;  // others are not compared
  };
  fail(request,
       excess({difference("position", 0), difference("velocity", 1), difference("acceleration", 2)},
              *settings.allowed));
  return request;
}

Peer read_peer(const RecordValue& node, const RecordSettings& settings) {
  const std::string name = node["peer"].name();
  return {read_candidate(node, settings, "a peer"),
          {read_case_size(node), "peer:" + name},
          name,
          node["library"].text(),
          node["library_version"].text(),
          node["method"].text(),
          node["guess"].name()};
}

Profile read_profile(const RecordValue& node) {
  Profile profile;
  const RecordValue time = node["time_per_step"], split = time["phases"];
  require_clock(time, Clock::wall, "a profile");
  for (std::size_t i = 0; i < phases.size(); ++i) profile[i] = split[phases[i]].not_negative();
  return profile;
}

}  // namespace

CaseSize read_case_size(const RecordValue& node) {
  return {node["case"].name(), node["coordinates"].integer(1)};
}

CandidateKey read_key(const RecordValue& node) { return {read_case_size(node), node["id"].text()}; }

void read_paper(Record& record, const RecordValue& experiment) {
  const RecordSettings& settings = record.settings;
  for (const char* list : {"candidates", "cells"})  // "cells" until schema 3.0.0
    read_each(experiment, list, [&](const RecordValue& node) {
      const CandidateKey key = read_timed_key(node);
      add_once(is_by_wall(key.id) ? record.wall_candidates : record.candidates, node, key,
               read_candidate(node, settings, key.id), name_of(key));
    });
  std::set<std::pair<CandidateKey, std::string>> seen;
  read_each(experiment, "requests", [&](const RecordValue& node) {
    MeasuredRequest request = read_request(node, settings);
    if (!seen.emplace(request.key, request.name).second)
      node.complain("the request " + request.name + " of " + request.key.id + " is given twice");
    record.requests.push_back(std::move(request));
  });
  read_each(experiment, "peers", [&](const RecordValue& node) {
    record.peers.push_back(read_peer(node, settings));
    const CandidateKey& key = record.peers.back().key;
    if (std::ranges::count(record.peers, key, &Peer::key) > 1)
      node.complain(name_of(key) + " is given twice");
  });
  read_each(experiment, "profiles", [&](const RecordValue& node) {
    const CandidateKey key = read_key(node);
    add_once(record.profiles, node, key, read_profile(node), name_of(key));
  });
}

}  // namespace desmo::report
