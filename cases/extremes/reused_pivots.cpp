// Row 11: factors and pivot orders that are reused while the mechanism passes a position in which
// coupler and rocker are nearly stretched.
#include <string>

#include "cases/extremes/rows.h"

namespace desmo::extremes {

std::vector<ExtremeCase> reused_pivots(Extent) {
  const DyadChain chain = one_dyad(2, 1, 6, 5, 3 + 1e-5);
  std::vector<ExtremeCase> all;
  for (const char* settings : {"", "/jacobian:step"}) {
    ExtremeCase c = case_of("a revolution" + std::string(settings), chain, 1, {0, 6.25e-4, 10'001});
    c.settings = settings;
    c.bound = Bound::new_pivots;
    c.factor = 2;
    all.push_back(c);
  }
  return all;
}

}  // namespace desmo::extremes
