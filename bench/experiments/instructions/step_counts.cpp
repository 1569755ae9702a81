#include "bench/experiments/instructions/step_counts.h"

#include <algorithm>

#include "bench/experiments/paper/extended_ids.h"
#include "bench/kit/checked_run.h"
#include "bench/kit/process/callgrind.h"
#include "bench/kit/variant_costs.h"
#include "bench/regression/rounds.h"
#include "cases/generators/cases.h"
#include "formulations/id.h"
#include "formulations/variants.h"

namespace desmo::instructions {

namespace {

/// Number of counted steps of a run that solves one instant after the other, without checks.
constexpr int steps = 50;
/// Numbers of steps of two motions, for any other run. The count of a motion includes its assembly,
/// which the difference of two counts does not. Checks take the difference of a checked run less
/// that of the same run without checks.
constexpr int short_motion = 100, long_motion = 300;

bool is_counted(const Variant& v) {
  return v.partition != Partition::block && !bench::is_dense_global(v) &&
         bench::slow_reason(v).empty();
}

/// Returns whether callgrind can count a formulation. It knows no registers wider than 256 bits. It
/// also counts what threads do while they wait for each other, which differs from run to run.
bool is_counted(std::string_view id) {
  const Settings settings = parse_id(id).settings;
  return std::max(settings.lanes, settings.segments) <= 4 && settings.threads == 1;
}

std::vector<std::string> counted_ids() {
  std::vector<std::string> ids;
  for (const Variant& v : variants())
    if (is_counted(v)) ids.push_back(v.id);
  for (const char* id : {"group_symbolic_explicit/lanes:4", "group_symbolic_explicit/segments:4"})
    ids.push_back(id);
  for (const std::string_view id : paper::extended_ids)
    if (is_counted(id)) ids.emplace_back(id);
  for (const std::string_view id : bench::checked_ids)
    for (const auto& [suffix, mode] : bench::check_suffixes)
      ids.push_back(std::string(id).append(suffix));
  return ids;
}

void count(StepCount& one, const std::string& desmo_steps) {
  const auto counted = [&](const std::string& id, int taken) {
    return bench::count_steps(
        one.text(),
        {desmo_steps, one.case_name, std::to_string(one.coordinates), id, std::to_string(taken)});
  };
  const auto step = [&](const std::string& id) {
    return counted(id, regression::CountingSettings::uncounted_steps + steps) / steps;
  };
  const auto more = [&](const std::string& id) {  // count of long_motion - short_motion steps
    return counted(id, long_motion) - counted(id, short_motion);
  };
  const std::string bare(bench::formulation_of(one.id));
  const Settings settings = parse_id(bare).settings;
  one.steps = long_motion - short_motion;
  if (bench::check_of(one.id) != CheckMode::none) {
    one.checks = (more(one.id) - more(bare)) / one.steps;
    one.instructions = step(bare) + one.checks;
  } else if (settings.segments > 1 || settings.stride > 1) {
    one.instructions = more(one.id) / one.steps;
  } else {
    one.instructions = step(one.id);
    one.steps = steps;
  }
}

}  // namespace

std::vector<StepCount> to_be_counted(int coordinates) {
  std::vector<StepCount> all;
  for (const Case& c : cases()) {
    const int size = coordinates > 0 ? coordinates : c.sizes.back();
    make_scene(c, size);  // throws where there is no such size
    for (const std::string& id : counted_ids()) all.push_back({{std::string(c.name), size, id}});
  }
  return all;
}

void count(std::vector<StepCount>& all, const std::string& desmo_steps) {
  bench::count_on_all_cores(all.size(), [&](std::size_t i) { count(all[i], desmo_steps); });
}

}  // namespace desmo::instructions
