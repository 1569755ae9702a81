// Row 8: growth of the error with time. The crank's angle at every instant is a double, so that the
// driver adds no rounding.
#include "cases/extremes/rows.h"

namespace desmo::extremes {

std::vector<ExtremeCase> long_runs(Extent extent) {
  constexpr double rate = 1.0 / 1024;  // rad/s
  const TimeGrid grid =
      extent == Extent::brief ? TimeGrid{0, 500, 20'001} : TimeGrid{0, 10, 1'000'001};
  ExtremeCase c = case_of("four-bar to 1e7 s", usual_chain(1, 0.5), rate, grid);
  c.bound = Bound::first_part;
  c.factor = 2;
  c.compared_at_ends = 1000;
  return {c};
}

}  // namespace desmo::extremes
