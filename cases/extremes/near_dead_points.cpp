// Row 2: a crank drives a four-bar through the position in which coupler and rocker are nearly
// stretched.
#include <numbers>

#include "cases/extremes/rows.h"
#include "cases/mechanism/formatted.h"

namespace desmo::extremes {

std::vector<ExtremeCase> near_dead_points(Extent extent) {
  std::vector<ExtremeCase> all;
  for (const double slack : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    for (const double way : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
      const bool is_corner = (slack == 1e-2 || slack == 1e-6 || slack == 1e-12) &&
                             (way == 1e-1 || way == 1e-3 || way == 1e-5);
      if (extent == Extent::brief && !is_corner) continue;
      // At θ = π coupler and rocker span a distance of 8, and are together longer by `slack`.
      const DyadChain chain = one_dyad(2, std::numbers::pi - way, 6, 5, 3 + slack);
      all.push_back(case_of(formatted("slack %.0e, within %.0e rad", slack, way), chain, 2 * way,
                            {0, 0.05, 21}));
      all.back().bound = Bound::floor;
      all.back().scene.tolerance = 1e-16;  // below rounding, which then ends the iteration
    }
  return all;
}

}  // namespace desmo::extremes
