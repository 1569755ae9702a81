#include "formulations/part_solvers.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace desmo {

std::vector<PartSolver> part_solvers(const Formulation& formulation) {
  std::vector<PartSolver> all;
  for (const Formulation::DefinedPart& part : formulation.parts()) {
    if (part.definition.constant) continue;
    auto it = std::ranges::find(all, part.algebra, &PartSolver::algebra);
    if (it == all.end()) it = all.insert(it, {part.algebra, 0, std::numeric_limits<int>::max(), 0});
    const int unknowns = static_cast<int>(part.definition.unknowns.size());
    ++it->parts;
    it->least_unknowns = std::min(it->least_unknowns, unknowns);
    it->most_unknowns = std::max(it->most_unknowns, unknowns);
  }
  std::ranges::stable_sort(all, std::greater{}, &PartSolver::most_unknowns);
  return all;
}

}  // namespace desmo
