#include "bench/experiments/instructions/step_counts.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "bench/kit/beyond.h"
#include "bench/regression/callgrind.h"
#include "formulations/id.h"
#include "formulations/variants.h"

namespace desmo::counting {

namespace {

constexpr int warm_up = 5;  // of desmo_steps, not counted
constexpr int steps = 50;
/// Where more than one instant is solved at once, assembly and entry are counted, too: what is left
/// of a long motion less a shorter one is steps.
constexpr int few_steps = 100, many_steps = 300;

bool is_counted(const Variant& v) {
  return v.partition != Partition::block && !is_dense_global(v) && algebra_name(v) != "spqr";
}

/// Callgrind knows no registers wider than 256 bits. What threads do while they wait for each other
/// it counts, too, and that is another number every time.
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
  for (const std::string_view id : suite::beyond_the_paper)
    if (is_counted(id)) ids.emplace_back(id);
  return ids;
}

void count(StepCount& one, const std::string& desmo_steps) {
  const auto counted = [&](int taken) {
    return regression::count_steps({desmo_steps, one.case_name, std::to_string(one.coordinates),
                                    one.id, std::to_string(taken)});
  };
  const Settings settings = parse_id(one.id).settings;
  if (settings.segments > 1 || settings.stride > 1) {
    one.steps = many_steps - few_steps;
    one.instructions = (counted(many_steps) - counted(few_steps)) / one.steps;
  } else {
    one.steps = steps;
    one.instructions = counted(warm_up + steps) / one.steps;
  }
}

}  // namespace

std::string StepCount::name() const {
  return case_name + "/" + std::to_string(coordinates) + "/" + id;
}

std::vector<StepCount> to_be_counted(int coordinates) {
  std::vector<StepCount> all;
  for (const Case& c : cases()) {
    const int size = coordinates > 0 ? coordinates : c.sizes.back();
    describe(c, size);  // throws where there is no such size
    for (const std::string& id : counted_ids()) all.push_back({std::string(c.name), size, id});
  }
  return all;
}

void count(std::vector<StepCount>& all, const std::string& desmo_steps) {
  regression::count_on_all_cores(all.size(), [&](std::size_t i) {
    try {
      count(all[i], desmo_steps);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("the instructions of " + all[i].name() +
                               " cannot be counted: " + error.what());
    }
  });
}

}  // namespace desmo::counting
