#include "report/statistics/comparability.h"
#include "report/statistics/variants.h"
#include "report/text/digits.h"
#include "report/text/document.h"

namespace desmo::report {
namespace {

Timing timing_of_steps(bool is_ok, const std::string& message, const std::vector<double>& seconds) {
  if (!is_ok) return {{std::nullopt, failed_mark}, message, {}};
  return {{summarise(seconds), {}}, {}, {}};
}

std::map<CandidateKey, Timing> timings_of(const std::map<CandidateKey, TimedSize>& entries) {
  std::map<CandidateKey, Timing> all;
  for (const auto& [key, entry] : entries)
    all[key] = timing_of_steps(entry.status == Status::ok, entry.message, entry.seconds_per_step);
  return all;
}

std::map<CandidateKey, Timing> timings_of(const std::map<PointKey, Point>& points) {
  std::map<CandidateKey, Timing> all;
  for (const auto& [key, point] : points)
    all[key_of(key)] =
        timing_of_steps(point.status == Point::Status::ok, point.message, point.seconds_per_step);
  return all;
}

}  // namespace

CandidateKey key_of(const PointKey& point) {
  const auto& [series, id] = point;
  return {series.case_name, series.coordinates,
          id + "/step:" + write_shortest(series.step_seconds) +
              "/instants:" + std::to_string(series.instants)};
}

std::vector<TimedGroup> timed_groups(const Record& record) {
  return {{"comparison", "CPU seconds", timings(record, Clock::cpu)},
          {"comparison_wall", "Wall-clock seconds", timings(record, Clock::wall)},
          {"comparison_growth", "CPU seconds of a step, growth", timings_of(record.growth)},
          {"comparison_break_even", "CPU seconds of a step, dense and sparse",
           timings_of(record.break_even)},
          {"comparison_accuracy", "CPU seconds of a step, accuracy", timings_of(record.points)}};
}

CandidateKey reference_of(const CandidateKey& key) {
  std::string suffix;
  for (const char* part : {"/request:", "/step:"})
    if (const std::size_t at = key.id.find(part); at != key.id.npos) suffix = key.id.substr(at);
  if (!is_by_wall(key.id))
    return {key.case_name, key.coordinates, std::string(usual_reference) + suffix};
  const std::string id = key.id.substr(0, key.id.size() - suffix.size());
  return {key.case_name, key.coordinates,
          without_setting(without_setting(id, "threads"), "clock") + "/clock:wall" + suffix};
}

}  // namespace desmo::report
