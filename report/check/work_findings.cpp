#include <cmath>

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

}  // namespace

WorkFindings find_works(const CheckRecord& check, const CheckRecord* baseline) {
  if (!check.work || !(baseline ? baseline->work.has_value() : check.base.has_value())) return {};
  const Work& then = baseline ? *baseline->work : *check.work;
  WorkFindings found{differences(check, baseline ? baseline->head : *check.base, then), {}};
  if (!found.differences.empty()) return found;
  for (const auto& [candidate, counts] : check.work->instructions) {
    const auto before = then.instructions.find(candidate);
    if (before == then.instructions.end()) continue;
    const std::int64_t head = *counts.head,
                       base = baseline ? *before->second.head : *before->second.base;
    const double exact = 100 * (static_cast<double>(head) / static_cast<double>(base) - 1);
    const double percent = std::round(10 * exact) / 10;
    found.candidates.push_back({candidate, base, head, percent, finding_of_work(percent)});
  }
  return found;
}

}  // namespace desmo::report
