// Row 2: a crank drives a four-bar through the position in which coupler and rocker are nearly
// stretched.
#include <array>
#include <cstdio>
#include <numbers>
#include <string>

#include "cases/extremes/rows.h"

namespace desmo::extremes {

namespace {

/// At θ = π coupler and rocker reach over 8, and are longer by `slack`.
DyadChain nearly_stretched(double slack, double start) {
  DyadChain chain{.crank = 2, .start = start, .dyads = {}};
  chain.dyads = {closed_dyad(crank_pin(chain), {6, 0, 0}, 5, 3 + slack, 1)};
  return chain;
}

std::string number(double value) {
  char text[16];
  std::snprintf(text, sizeof text, "%.0e", value);
  return text;
}

}  // namespace

std::vector<ExtremeCase> near_dead_points(Extent extent) {
  std::vector<ExtremeCase> all;
  for (const double slack : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    for (const double way : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
      const bool is_corner = (slack == 1e-2 || slack == 1e-6 || slack == 1e-12) &&
                             (way == 1e-1 || way == 1e-3 || way == 1e-5);
      if (extent == Extent::brief && !is_corner) continue;
      const DyadChain chain = nearly_stretched(slack, std::numbers::pi - way);
      all.push_back(case_of("slack " + number(slack) + ", within " + number(way) + " rad", chain,
                            2 * way, {0, 0.05, 21}));
      all.back().bound = Bound::floor;
      all.back().scene.tolerance = 1e-16;  // as far as rounding lets it
    }
  return all;
}

}  // namespace desmo::extremes
