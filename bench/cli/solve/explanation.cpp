#include <algorithm>

#include "bench/cli/inspect/inspection.h"
#include "bench/cli/solve/run_notes.h"
#include "bench/cli/text.h"
#include "bench/kit/problem.h"

namespace desmo::cli {
namespace {

constexpr std::size_t names_shown = 8;

std::string fraction(int kept, int all, const std::string& noun) {
  return std::to_string(kept) + " of " + count(all, noun);
}

std::string group_text(const Plan::GroupUse& use) {
  std::string text = use.name + ": keeps " + fraction(use.kept_unknowns, use.unknowns, "unknown") +
                     " in " + fraction(use.kept_blocks, use.blocks, "block") + ", to " +
                     bench::level_names[use.level];
  if (!use.serves.empty()) text += "; serves " + use.serves;
  text += "; kept: " + enumerate(use.kept, names_shown);
  if (!use.dropped.empty()) text += "; dropped: " + enumerate(use.dropped, names_shown);
  return text;
}

std::vector<std::string> drivers_not_needed(const Plan& plan, const Model& whole) {
  const std::vector<std::string> kept = driver_names(plan.model);
  std::vector<std::string> names = driver_names(whole);
  std::erase_if(names, [&](const std::string& name) { return std::ranges::count(kept, name) > 0; });
  return names;
}

}  // namespace

std::string explain(const Plan& plan, const Model& whole) {
  int kept = 0, all = 0;
  std::string groups;
  std::vector<std::string> not_needed;
  for (const Plan::GroupUse& use : plan.groups) {
    kept += use.kept_unknowns;
    all += use.unknowns;
    if (use.kept.empty())
      not_needed.push_back(use.name);
    else
      groups += "  " + wrap(group_text(use), 4) + "\n";
  }
  if (!not_needed.empty())
    groups += "  " + wrap("groups not needed: " + enumerate(not_needed, names_shown), 4) + "\n";
  std::string text =
      "solved: " + fraction(kept, all, "unknown") + ", " +
      fraction(plan.model.degrees_of_freedom(), whole.degrees_of_freedom(), "driver") + "\n" +
      groups;
  if (const auto unused = drivers_not_needed(plan, whole); !unused.empty())
    text += "  " + wrap("drivers not needed: " + enumerate(unused, names_shown), 4) + "\n";
  return text;
}

}  // namespace desmo::cli
