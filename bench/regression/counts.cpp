#include "bench/regression/counts.h"

#include <stdexcept>

#include "bench/kit/process/callgrind.h"
#include "bench/regression/cell_name.h"
#include "bench/regression/cells.h"

namespace desmo::regression {

namespace {

std::int64_t count(const Side& side, const std::string& name) {
  const CellName cell = parse_cell(name);
  try {
    return count_steps({side.folder + "/desmo_steps", cell.case_name,
                        std::to_string(cell.coordinates), cell.id, std::to_string(steps),
                        std::to_string(iterations),
                        std::to_string(name == side.slowed ? side.percent : 0)});
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("the instructions of " + name + " cannot be counted in " + side.name +
                             ": " + error.what());
  }
}

}  // namespace

Counts count_instructions(const std::vector<Counted>& all) {
  std::vector<std::int64_t> instructions(all.size());
  count_on_all_cores(all.size(),
                     [&](std::size_t i) { instructions[i] = count(*all[i].side, all[i].cell); });
  Counts counts;
  for (std::size_t i = 0; i < all.size(); ++i)
    counts[all[i].cell][all[i].side->name] = instructions[i];
  return counts;
}

}  // namespace desmo::regression
