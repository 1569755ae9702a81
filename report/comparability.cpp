#include "report/comparability.h"

#include <optional>
#include <set>

#include "report/digits.h"
#include "report/measurements.h"

namespace desmo::report {
namespace {

class Comparison {
 public:
  void require_same(const std::string& what, const std::optional<std::string>& first,
                    const std::optional<std::string>& second) {
    if (!first || !second || *first != *second)
      differ(what, first.value_or("not recorded"), second.value_or("not recorded"));
  }

  void differ(const std::string& what, const std::string& first, const std::string& second) {
    if (named_.insert(what).second)  // once for all cells of a case and size
      differences_.push_back({what, first, second});
  }

  std::vector<Difference> differences() && { return std::move(differences_); }

 private:
  std::vector<Difference> differences_;
  std::set<std::string> named_;
};

std::optional<std::string> linking_of(const Build& build) {
  if (!build.link) return std::nullopt;
  return build.link->type + (build.link->flags.empty() ? "" : " " + build.link->flags);
}

void compare_environment(Comparison& all, const Record& a, const Record& b) {
  all.require_same("CPU model", a.machine.cpu, b.machine.cpu);
  all.require_same("compiler", a.build.compiler, b.build.compiler);
  all.require_same("build type", a.build.type, b.build.type);
  all.require_same("flags", a.build.flags, b.build.flags);
  all.require_same("linking", linking_of(a.build), linking_of(b.build));
  all.require_same("BLAS core", a.blas.core, b.blas.core);
  all.require_same("BLAS threads", std::to_string(a.blas.threads), std::to_string(b.blas.threads));
}

void require_same_number(Comparison& all, const char* what, double first, double second) {
  all.require_same(what, write_shortest(first), write_shortest(second));
}

void compare_settings(Comparison& all, const Settings& a, const Settings& b) {
  require_same_number(all, "tolerance", a.tolerance, b.tolerance);
  require_same_number(all, "iterations at most", static_cast<double>(a.max_iterations),
                      static_cast<double>(b.max_iterations));
  all.require_same("first guess", a.guess, b.guess);
}

void compare_motions(Comparison& all, const Settings& a, const Settings& b) {
  require_same_number(all, "step", a.step_seconds, b.step_seconds);
  require_same_number(all, "duration", a.duration_seconds, b.duration_seconds);
}

// Of what has no time in one of them, there is nothing to compare.
void compare_timings(Comparison& all, const Record& a, const Record& b) {
  const auto second = timings(b, Clock::cpu);
  bool shared = false;
  for (const auto& [key, one] : timings(a, Clock::cpu)) {
    const auto other = second.find(key);
    if (other == second.end()) continue;
    shared = true;
    if (!one.time.seconds || !other->second.time.seconds) continue;
    const std::string place = key.case_name + "/" + std::to_string(key.coordinates);
    const auto request = key.id.find("/request:");
    all.require_same("model of " + place, one.origin.model, other->second.origin.model);
    all.require_same("results of " + place + (request == key.id.npos ? "" : key.id.substr(request)),
                     one.origin.results, other->second.origin.results);
  }
  if (!shared) all.differ("cells in common", "none", "none");
}

}  // namespace

std::vector<Difference> why_incomparable(const Record& first, const Record& second) {
  Comparison all;
  compare_environment(all, first, second);
  compare_settings(all, first.settings, second.settings);
  compare_motions(all, first.settings, second.settings);
  compare_timings(all, first, second);
  return std::move(all).differences();
}

std::vector<Difference> why_apart(const Record& first, const Record& second) {
  Comparison all;
  compare_environment(all, first, second);
  compare_settings(all, first.settings, second.settings);
  const auto only_one = [&](const char* what, bool in_first, bool in_second) {
    if (in_first && in_second) all.differ(std::string("one record with ") + what, "one", "another");
  };
  only_one("cells", has_cells(first), has_cells(second));
  only_one("points", !first.points.empty(), !second.points.empty());
  only_one("promises", !first.tuning.empty(), !second.tuning.empty());
  only_one("sizes", has_sizes(first), has_sizes(second));
  only_one("instructions", !first.instructions.empty(), !second.instructions.empty());
  only_one("extremes", !first.extremes.empty(), !second.extremes.empty());
  return std::move(all).differences();
}

std::string describe(const std::vector<Difference>& differences) {
  std::string text;
  for (const Difference& d : differences)
    text += d.what + ": " + d.first + " here, " + d.second + " there\n";
  return text;
}

}  // namespace desmo::report
