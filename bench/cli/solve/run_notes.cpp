#include "bench/cli/solve/run_notes.h"

#include <algorithm>
#include <vector>

#include "bench/cli/text.h"
#include "cases/mechanism/formatted.h"
#include "formulations/base/per_level.h"
#include "formulations/model/partition.h"
#include "formulations/motion/internals.h"

namespace desmo::cli {

namespace {

constexpr std::size_t names_shown = 8;

std::string fraction(int kept, int all, const std::string& noun) {
  return std::to_string(kept) + " of " + count(all, noun);
}

std::string use_text(const Plan::GroupUse& use) {
  std::string text = use.name + ": keeps " + fraction(use.kept_unknowns, use.unknowns, "unknown") +
                     " in " + fraction(use.kept_blocks, use.blocks, "block") + ", to " +
                     level_names[use.level];
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
      groups += "  " + wrap(use_text(use), 4) + "\n";
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

std::string note_on_code(const Formulation& f, bool named) {
  const auto without = std::ranges::count(parts_of(f), false, &DefinedPart::as_named);
  if (without == 0) return "";
  return "note: no generated code for " + std::to_string(without) + " of " +
         count(static_cast<long>(parts_of(f).size()), "part") +
         (without == 1 ? "; it is evaluated automatically" : "; they are evaluated automatically") +
         (named ? "\n" : " (name a formulation with --formulation to have it generated)\n");
}

std::string note_on_tolerance(const Formulation& f, double asked) {
  if (f.tolerance() < 1.01 * asked) return "";
  return formatted(
      "note: the tolerance %.2g is below what rounding leaves; positions were solved to %.2g\n",
      asked, f.tolerance());
}

std::string note_on_refusals(const Formulation& f, bool named) {
  const auto [refactorisations, steps, changes] = part_counts(f);
  long parts = 0;
  for (const DefinedPart& part : parts_of(f)) parts += part.solver->counts().fallbacks > 0;
  if (steps == 0) return "";
  std::string note = "note: generated code left " + count(steps, "step") + " of " +
                     count(parts, "part") +
                     " to a more general solver, some 10 times slower; the numbers are as exact";
  if (changes > 0)
    note += "; " + std::to_string(changes) + " of them on another assembly branch than before";
  if (!named) note += " (name a formulation with --formulation to have better code generated)";
  return note + "\n";
}

std::string note_on_steps(const Formulation& f) {
  if (stepping_of(f).runs_without_segments() == 0) return "";
  return "note: solved step by step, for the motion is short or could not be solved in segments\n";
}

std::string note_on_unseen(const Plan& plan, const Model& whole) {
  std::vector<std::string> groups;
  for (std::size_t g = 0; g < plan.groups.size(); ++g)
    if (plan.groups[g].may_lock) groups.push_back(named_group(whole.groups[g]));
  if (groups.empty()) return "";
  return "note: not checked: " + enumerate(groups, names_shown) +
         ", which the request does not need; the motion may lock there, or equations may not hold "
         "(--check mechanism checks all)\n";
}

}  // namespace desmo::cli
