// Row 7: the same mechanism in other units, and mechanisms of different size in one model.
#include "cases/extremes/rows.h"
#include "cases/mechanism/formatted.h"

namespace desmo::extremes {

namespace {

constexpr TimeGrid scale_grid{0, 0.05, 61};

ExtremeCase as_first(ExtremeCase c) {
  c.bound = Bound::first_case;
  c.factor = 4;
  return c;
}

ExtremeCase scaled(double scale) {
  return as_first(
      case_of(formatted("× %.0e", scale), usual_chain(3, chain_start, scale), 1, scale_grid));
}

ExtremeCase both() {
  DyadChain small = usual_chain(3, chain_start, 1e-9), large = usual_chain(3, chain_start, 1e9);
  small.prefix = "small/";
  large.prefix = "large/";
  const Motion turning = Polynomial{{chain_start, 1}};
  return as_first(
      case_of("× 1e-9 and × 1e9 in one", {small, large}, {turning, turning}, scale_grid));
}

}  // namespace

std::vector<ExtremeCase> scales(Extent) {
  return {case_of("× 1", usual_chain(3, chain_start), 1, scale_grid),
          scaled(1e-9),
          scaled(1e9),
          both(),
          scaled(1e-150),
          scaled(1e150)};
}

}  // namespace desmo::extremes
