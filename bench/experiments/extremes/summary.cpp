#include "bench/experiments/extremes/summary.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

namespace desmo::extremes {

std::size_t count(const std::vector<Result>& results, Verdict verdict) {
  return static_cast<std::size_t>(std::ranges::count_if(
      results, [&](const Result& r) { return r.judgement.verdict == verdict; }));
}

std::string summary(const Extreme& row, const std::vector<Result>& results) {
  char head[160];
  std::snprintf(head, sizeof head,
                "%2d %-22.*s as expected %4zu, missed %4zu, DEFECT %4zu, n/a %4zu\n", row.number,
                static_cast<int>(row.name.size()), row.name.data(),
                count(results, Verdict::as_expected), count(results, Verdict::missed),
                count(results, Verdict::defect), count(results, Verdict::not_applicable));
  std::string text = head;
  using Kind = std::pair<std::string, Verdict>;
  std::map<Kind, std::vector<const Result*>> found;
  for (const Result& r : results)
    if (const Verdict v = r.judgement.verdict; v == Verdict::missed || v == Verdict::defect)
      found[{r.case_name, v}].push_back(&r);
  for (const auto& [kind, all] : found)
    text += "     " + std::string(kind.second == Verdict::defect ? "DEFECT" : "missed") + " by " +
            std::to_string(all.size()) + ": " + kind.first + "; " + all.front()->id + ": " +
            all.front()->judgement.reason + "\n";
  return text;
}

}  // namespace desmo::extremes
