// Row 13: tolerances from coarse ones to some beyond double precision.
#include <string>

#include "cases/extremes/rows.h"

namespace desmo::extremes {

std::vector<ExtremeCase> tolerances(Extent) {
  std::vector<ExtremeCase> all;
  for (int digits = 3; digits <= 16; ++digits) {
    const std::string tolerance = "1e-" + std::to_string(digits);
    ExtremeCase c = case_of(tolerance, usual_chain(5, chain_start), 1, {0, 0.03, 101});
    c.scene.tolerance = std::stod(tolerance);
    all.push_back(c);
  }
  return all;
}

}  // namespace desmo::extremes
