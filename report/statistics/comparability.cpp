#include "report/statistics/comparability.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "report/statistics/variants.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

const CandidateKey& timing_key(const CandidateKey& key) { return key; }

/// Returns the measurements of a step among entries: sizes or points.
template <class Entries>
Measurements steps_of(const Entries& entries) {
  Measurements all;
  for (const auto& [key, entry] : entries) all[timing_key(key)] = &entry;
  return all;
}

}  // namespace

CandidateKey timing_key(const PointKey& point) {
  const auto& [series, id] = point;
  return {series, id + "/step:" + write_shortest(series.step_seconds) +
                      "/instants:" + std::to_string(series.instants)};
}

std::vector<TimedGroup> timed_groups(const Record& record) {
  return {{"machines", "CPU seconds", measurements_by(Clock::cpu, record)},
          {"machines_wall", "Wall-clock seconds", measurements_by(Clock::wall, record)},
          {"machines_growth", "CPU seconds of a step, growth", steps_of(record.growth)},
          {"machines_break_even", "CPU seconds of a step, dense and sparse",
           steps_of(record.break_even)},
          {"machines_accuracy", "CPU seconds of a step, accuracy", steps_of(record.points)},
          {"machines_modelling", "CPU seconds of a step, coordinates", steps_of(record.modelled)}};
}

CandidateKey reference_of(const CandidateKey& key) {
  if (is_by_wall(key.id)) {
    const std::string request(request_of(key.id)), all = without_setting(key.id, "request");
    return {key,
            without_setting(without_setting(all, "threads"), "clock") + "/clock:wall" + request};
  }
  std::string suffix;
  for (const char* part : {"/request:", "/step:"})
    if (const std::size_t at = key.id.find(part); at != key.id.npos) suffix = key.id.substr(at);
  return {key, std::string(usual_reference) + suffix};
}

namespace {

/// Differences found so far. A quantity is listed once, by its first difference.
struct Comparison {
  void require_same(const std::string& what, const std::optional<std::string>& first,
                    const std::optional<std::string>& second) {
    if (!first || !second || *first != *second)
      differ(what, first.value_or("not recorded"), second.value_or("not recorded"));
  }

  void require_same(const std::string& what, double first, double second) {
    require_same(what, write_shortest(first), write_shortest(second));
  }

  void differ(const std::string& what, const std::string& first, const std::string& second) {
    if (!std::ranges::count(differences, what, &Difference::what))
      differences.push_back({what, first, second});
  }

  std::vector<Difference> differences;
};

void compare_environment(Comparison& all, const Record& a, const Record& b) {
  all.require_same("CPU model", a.machine.cpu, b.machine.cpu);
  all.require_same("compiler", a.build.compiler, b.build.compiler);
  all.require_same("build type", a.build.type, b.build.type);
  all.require_same("flags", a.build.flags, b.build.flags);
  all.require_same("linking", a.build.link, b.build.link);
  all.require_same("BLAS core", a.blas.core, b.blas.core);
  all.require_same("BLAS threads", static_cast<double>(a.blas.threads),
                   static_cast<double>(b.blas.threads));
}

void compare_settings(Comparison& all, const RecordSettings& a, const RecordSettings& b) {
  all.require_same("tolerance", a.tolerance, b.tolerance);
  all.require_same("iterations at most", static_cast<double>(a.max_iterations),
                   static_cast<double>(b.max_iterations));
  all.require_same("first guess", a.guess, b.guess);
  all.require_same("step", a.step_seconds, b.step_seconds);
  all.require_same("duration", a.duration_seconds, b.duration_seconds);
}

// Compares the digests of candidates that have a time on both sides. Peers find other coordinates
// and have no digests, so that neither side having one is no difference.
void compare_timings(Comparison& all, const TimedGroup& a, const TimedGroup& b) {
  for (const auto& [key, one] : a.measurements) {
    const auto other = b.measurements.find(key);
    if (other == b.measurements.end() || one->status != Status::ok ||
        other->second->status != Status::ok)
      continue;
    const Origin &first = one->origin, &second = other->second->origin;
    const std::string place = key.case_name + "/" + std::to_string(key.coordinates);
    if (first.model || second.model)
      all.require_same("model of " + place, first.model, second.model);
    if (first.results || second.results)
      all.require_same("results of " + place + std::string(request_of(key.id)), first.results,
                       second.results);
  }
}

template <class Map>
bool share_a_key(const Map& a, const Map& b) {
  return std::ranges::any_of(a, [&](const auto& entry) { return b.contains(entry.first); });
}

void compare_measured(Comparison& all, const Record& first, const Record& second) {
  bool shared = share_a_key(first.instructions, second.instructions);
  const std::vector<TimedGroup> a = timed_groups(first), b = timed_groups(second);
  for (std::size_t i = 0; i < a.size(); ++i) {
    compare_timings(all, a[i], b[i]);
    shared = shared || share_a_key(a[i].measurements, b[i].measurements);
  }
  if (!shared) all.differ("measurements in common", "none", "none");
}

}  // namespace

std::vector<Difference> different_work_reasons(const Record& first, const Record& second) {
  Comparison all;
  compare_settings(all, first.settings, second.settings);
  compare_measured(all, first, second);
  return all.differences;
}

std::vector<Difference> incomparable_reasons(const Record& first, const Record& second) {
  Comparison all;
  compare_environment(all, first, second);
  std::ranges::move(different_work_reasons(first, second), std::back_inserter(all.differences));
  return all.differences;
}

}  // namespace desmo::report
