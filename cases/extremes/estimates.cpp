// Row 14: checks of the stated condition numbers and radii. Cases are those of other rows, one that
// approaches a dead point, and mechanisms of the library.
#include <algorithm>
#include <iterator>
#include <numbers>
#include <vector>

#include "cases/extremes/rows.h"
#include "cases/io/files.h"

namespace desmo::extremes {

namespace {

/// Makes a case that ends at a dead point that is missed by 1e-10. Its condition number grows more
/// than a thousandfold in small steps.
ExtremeCase approaching_a_dead_point() {
  const DyadChain chain = one_dyad(2, std::numbers::pi - 0.5, 6, 5, 3 + 1e-10);
  return case_of("approaching a dead point", chain, 0.5, {0, 0.002, 501});
}

}  // namespace

std::vector<ExtremeCase> estimates(Extent extent) {
  std::vector<ExtremeCase> all = near_dead_points(extent);
  all.push_back(approaching_a_dead_point());
  std::ranges::move(tolerances(extent), std::back_inserter(all));
  for (ExtremeCase& c : reused_pivots(extent))
    if (!c.settings.empty()) all.push_back(c);
  for (const char* name : {"andrews", "delta", "rssr", "stewart"})
    all.push_back({.name = name, .scene = library_scene(name)});
  for (ExtremeCase& c : all) {
    c.bound = Bound::estimates;
    c.factor = 1000;
  }
  return all;
}

}  // namespace desmo::extremes
