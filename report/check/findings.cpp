#include "report/check/findings.h"

#include <cmath>
#include <map>

#include "report/statistics/statistics.h"

namespace desmo::report {
namespace {

// Returns 1 where a change is an alarm, −1 where it is an improvement, 0 where it is neither.
int direction(const Change& c) {
  if (c.ratio > max_change && c.low > max_certain_change) return 1;
  if (c.ratio < 1 / max_change && c.high < 1 / max_certain_change) return -1;
  return 0;
}

bool beyond(double ratio, double limit) { return ratio > limit || ratio < 1 / limit; }

bool is_wide(const Change& c) { return c.high / c.low > max_interval_width; }

// Returns whether a change that is no alarm is too large or too uncertain to count as none.
bool is_undecided(const Change& c) { return is_wide(c) || beyond(c.ratio, max_change); }

using Pass = std::map<std::string, Rounds>;  // by name_of() the candidate, and by control_name

Pass first_pass(const CheckRecord& check) {
  Pass pass;
  if (!check.base) return pass;
  for (const auto& [key, head] : check.head.candidates)
    if (const Measurement& base = check.base->candidates.at(key);
        base.status == Status::ok && head.status == Status::ok)
      pass[name_of(key)] = {base.time.seconds, head.time.seconds};
  if (!pass.empty()) pass[control_name] = check.control;
  return pass;
}

Finding finding_of_time(const Change& first, const std::optional<Change>& second) {
  const int seen = direction(first);
  if (seen == 0) return is_undecided(first) ? Finding::noisy : Finding::same;
  if (!second) return Finding::unconfirmed;
  if (direction(*second) == seen) return seen > 0 ? Finding::regression : Finding::improvement;
  return is_undecided(*second) ? Finding::noisy : Finding::refuted;
}

Finding finding_of_work(double percent) {
  if (percent >= min_alarming_percent) return Finding::regression;
  if (percent <= -min_alarming_percent) return Finding::improvement;
  return Finding::same;
}

Change change(const Rounds& rounds) { return median_change(rounds.head, rounds.base); }

}  // namespace

bool is_unsteady(const Change& control) {
  return is_wide(control) || beyond(control.ratio, max_control_change);
}

TimeFindings find_times(const CheckRecord& check) {
  const Pass first = first_pass(check), &second = check.second;
  if (first.empty()) return {};
  const Change control = change(first.at(control_name));
  const bool first_unsteady = is_unsteady(control);
  const bool second_unsteady = !second.empty() && is_unsteady(change(second.at(control_name)));
  TimeFindings findings{control, {}};
  for (const auto& [candidate, rounds] : first) {
    if (candidate == control_name) continue;
    TimeFinding finding{candidate, summarise(rounds.base).median, summarise(rounds.head).median,
                        change(rounds)};
    if (const auto again = second.find(candidate); again != second.end())
      finding.second = change(again->second);
    const bool unsteady = first_unsteady || (second_unsteady && finding.second);
    finding.outcome = unsteady ? Finding::noisy : finding_of_time(finding.first, finding.second);
    findings.candidates.push_back(std::move(finding));
  }
  return findings;
}

namespace {

/// Returns the first two words of a library's version: "OpenBLAS 0.3.21" of "OpenBLAS 0.3.21 ...
/// Haswell ...", the rest of which depends on the processor.
std::string product(const std::string& version) {
  return version.substr(0, version.find(' ', version.find(' ') + 1));
}

std::vector<Difference> differences(const CheckRecord& now, const Record& then,
                                    const Work& then_work) {
  std::vector<Difference> all;
  const auto require_same = [&](const std::string& what, const std::string& first,
                                const std::string& second) {
    if (first != second) all.push_back({what, first, second});
  };
  const Record& head = now.head;
  require_same("compiler", then.build.compiler, head.build.compiler);
  require_same("build type", then.build.type, head.build.type);
  require_same("flags", then.build.flags, head.build.flags);
  require_same("linking", then.build.link.value_or("not recorded"),
               head.build.link.value_or("not recorded"));
  for (const auto& [name, version] : head.libraries)
    if (const auto other = then.libraries.find(name); other != then.libraries.end())
      require_same(name, product(other->second), product(version));
  require_same("counting tool", then_work.tool, now.work->tool);
  require_same("steps counted", std::to_string(then_work.steps), std::to_string(now.work->steps));
  require_same("iterations a step", std::to_string(then_work.iterations),
               std::to_string(now.work->iterations));
  return all;
}

}  // namespace

WorkFindings find_works(const CheckRecord& check, const CheckRecord* baseline) {
  if (!check.work || !(baseline ? baseline->work.has_value() : check.base.has_value())) return {};
  const Work& then = baseline ? *baseline->work : *check.work;
  WorkFindings found{differences(check, baseline ? baseline->head : *check.base, then), {}};
  if (!found.differences.empty()) return found;
  for (const auto& [candidate, counts] : check.work->instructions) {
    const auto before = then.instructions.find(candidate);
    if (before == then.instructions.end()) continue;
    const std::int64_t head = counts.head,
                       base = baseline ? before->second.head : *before->second.base;
    const double exact = 100 * (static_cast<double>(head) / static_cast<double>(base) - 1);
    const double percent = std::round(10 * exact) / 10;
    found.candidates.push_back({candidate, base, head, percent, finding_of_work(percent)});
  }
  return found;
}

}  // namespace desmo::report
