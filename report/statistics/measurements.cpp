#include "report/statistics/measurements.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "report/statistics/paper.h"
#include "report/statistics/variants.h"
#include "report/text/digits.h"
#include "report/text/document.h"

namespace desmo::report {

namespace {

Measured measured(Status status, const Time& time) {
  switch (status) {
    case Status::ok:
      return {summarise(time.seconds, time.windows), {}, time.clock};
    case Status::failed:
      return {std::nullopt, failed_mark};
    case Status::not_run:
      break;
  }
  return {std::nullopt, not_run_mark};
}

}  // namespace

Measured measured(const Record& record, const CandidateKey& key) {
  const auto candidate = record.candidates.find(key);
  if (candidate == record.candidates.end()) return {std::nullopt, missing_mark};
  return measured(candidate->second);
}

Measured measured(const Candidate& candidate) { return measured(candidate.status, candidate.time); }

Measured measured(const Request& request) { return measured(request.status, request.time); }

std::map<CandidateKey, Timing> timings(const Record& record, Clock clock) {
  const bool by_wall = clock == Clock::wall;
  std::map<CandidateKey, Timing> all;
  for (const auto& [key, candidate] : by_wall ? record.wall_candidates : record.candidates)
    all[key] = {measured(candidate), remark(candidate.status, candidate.message), candidate.origin};
  for (const Request& request : by_wall ? record.wall_requests : record.requests) {
    CandidateKey key = request.candidate;
    key.id += "/request:" + request.name;
    all[key] = {measured(request), remark(request.status, request.message), request.origin};
  }
  if (by_wall) return all;
  for (const Peer& peer : record.peers)
    all[key_of(peer)] = {measured(peer.candidate),
                         remark(peer.candidate.status, peer.candidate.message),
                         peer.candidate.origin};
  return all;
}

MeasuredSpeedUp measured_speed_up(const Record& record, const CandidateKey& reference,
                                  const CandidateKey& variant) {
  return measured_speed_up(measured(record, reference), measured(record, variant));
}

MeasuredSpeedUp measured_speed_up(const Measured& reference, const Measured& variant) {
  if (!variant.seconds) return {std::nullopt, variant.mark};
  if (!reference.seconds) return {std::nullopt, "reference " + reference.mark};
  if (reference.clock != variant.clock)
    throw std::logic_error("CPU time and wall-clock time make no ratio");
  return {speed_up(*reference.seconds, *variant.seconds), {}};
}

MeanSpeedUp mean_speed_up(const Record& record, std::string_view family, std::size_t reference,
                          std::size_t variant, std::span<const std::int64_t> sizes) {
  std::vector<SpeedUp> found;
  for (const std::int64_t size : sizes) {
    const auto one = measured_speed_up(record, family_key(variants[reference], size, family),
                                       family_key(variants[variant], size, family));
    if (one.speed_up) found.push_back(*one.speed_up);
  }
  if (found.empty()) return {};
  return {mean(found), found.size()};
}

std::vector<std::int64_t> recorded_sizes(const Record& record, std::string_view case_name) {
  std::set<std::int64_t> sizes;
  for (const auto& [key, candidate] : record.candidates)
    if (key.case_name == case_name) sizes.insert(key.coordinates);
  return {sizes.begin(), sizes.end()};
}

std::vector<std::string_view> recorded_families(const Record& record) {
  std::vector<std::string_view> families;
  for (const std::string_view family : sparse_families)
    if (std::any_of(record.candidates.begin(), record.candidates.end(), [&](const auto& candidate) {
          const std::string& id = candidate.first.id;  // group_symbolic_klu/lanes:8
          return id.substr(0, id.find('/')).ends_with("_" + std::string(family));
        }))
      families.push_back(family);
  return families;
}

Sources sources(const Record& record) {
  const double duration = record.settings.duration_seconds;
  if (std::abs(duration - published_duration) < 1e-9) return {"ours", "paper", {}, {}};
  const std::string ours = write_shortest(duration) + " s";
  const std::string paper = write_shortest(published_duration) + " s";
  const std::string motions = "Ours is " + ours + " of motion, the paper's " + paper;
  return {"ours, " + ours, "paper, " + paper, motions + ": these times are not to be compared.",
          motions + ": these are ratios of times of unequal motions."};
}

std::string remark(Status status, const std::string& message) {
  if (status == Status::ok) return {};
  return message.empty() ? "no reason recorded" : message;
}

}  // namespace desmo::report
