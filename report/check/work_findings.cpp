#include <cmath>
#include <functional>

#include "report/check/findings.h"

namespace desmo::report {
namespace {

/// "OpenBLAS 0.3.21" of "OpenBLAS 0.3.21 ... Haswell ...": the rest tells of the processor.
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

using FindBefore = std::function<std::optional<std::int64_t>(const std::string& candidate)>;

std::vector<WorkFinding> compare(const Work& work, const FindBefore& before) {
  std::vector<WorkFinding> findings;
  for (const auto& [candidate, counts] : work.instructions) {
    const auto base = before(candidate);
    if (!base) continue;
    const double exact = 100 * (static_cast<double>(*counts.head) / static_cast<double>(*base) - 1);
    const double percent = std::round(10 * exact) / 10;
    findings.push_back({candidate, *base, *counts.head, percent, outcome_of_work(percent)});
  }
  return findings;
}

}  // namespace

WorkFindings find_works(const CheckRecord& check) {
  if (!check.work || !check.base) return {};
  WorkFindings found{differences(check, *check.base, *check.work), {}};
  if (found.differences.empty())
    found.candidates = compare(*check.work, [&](const std::string& candidate) {
      return check.work->instructions.at(candidate).base;
    });
  return found;
}

WorkFindings find_works(const CheckRecord& check, const CheckRecord& baseline) {
  if (!check.work || !baseline.work) return {};
  WorkFindings found{differences(check, baseline.head, *baseline.work), {}};
  if (found.differences.empty())
    found.candidates = compare(*check.work, [&](const std::string& candidate) {
      const auto before = baseline.work->instructions.find(candidate);
      return before == baseline.work->instructions.end() ? std::nullopt : before->second.head;
    });
  return found;
}

}  // namespace desmo::report
