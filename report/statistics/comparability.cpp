#include "report/statistics/comparability.h"

#include <algorithm>
#include <optional>

#include "report/text/digits.h"

namespace desmo::report {
namespace {

/// What differs, each once for all candidates of a case and size.
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

void compare_settings(Comparison& all, const Settings& a, const Settings& b) {
  all.require_same("tolerance", a.tolerance, b.tolerance);
  all.require_same("iterations at most", static_cast<double>(a.max_iterations),
                   static_cast<double>(b.max_iterations));
  all.require_same("first guess", a.guess, b.guess);
}

void compare_motions(Comparison& all, const Settings& a, const Settings& b) {
  all.require_same("step", a.step_seconds, b.step_seconds);
  all.require_same("duration", a.duration_seconds, b.duration_seconds);
}

// Of what has no time in one of them, there is nothing to compare. Peers find other coordinates, of
// which there is no digest.
void compare_timings(Comparison& all, const TimedGroup& a, const TimedGroup& b) {
  for (const auto& [key, one] : a.timings) {
    const auto other = b.timings.find(key);
    if (other == b.timings.end() || !one.time.seconds || !other->second.time.seconds) continue;
    const Origin &first = one.origin, &second = other->second.origin;
    const std::string place = key.case_name + "/" + std::to_string(key.coordinates);
    const auto request = key.id.find("/request:");
    if (first.model || second.model)
      all.require_same("model of " + place, first.model, second.model);
    if (first.results || second.results)
      all.require_same(
          "results of " + place + (request == key.id.npos ? "" : key.id.substr(request)),
          first.results, second.results);
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
    shared = shared || share_a_key(a[i].timings, b[i].timings);
  }
  if (!shared) all.differ("measurements in common", "none", "none");
}

void compare_work(Comparison& all, const Record& first, const Record& second) {
  compare_settings(all, first.settings, second.settings);
  compare_motions(all, first.settings, second.settings);
  compare_measured(all, first, second);
}

}  // namespace

bool are_of_two_machines(const Record& first, const Record& second) {
  return first.machine.cpu != second.machine.cpu;
}

std::vector<Difference> why_incomparable(const Record& first, const Record& second) {
  Comparison all;
  compare_environment(all, first, second);
  compare_work(all, first, second);
  return all.differences;
}

std::vector<Difference> different_work_reason(const Record& first, const Record& second) {
  Comparison all;
  compare_work(all, first, second);
  return all.differences;
}

std::vector<Difference> why_apart(const Record& first, const Record& second) {
  Comparison all;
  compare_environment(all, first, second);
  compare_settings(all, first.settings, second.settings);
  for (const Experiment& experiment : experiments)
    if (experiment.is_in(first) && experiment.is_in(second))
      all.differ("one record with " + std::string(experiment.name), "one", "another");
  return all.differences;
}

}  // namespace desmo::report
