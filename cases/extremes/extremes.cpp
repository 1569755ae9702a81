#include "cases/extremes/extremes.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "cases/extremes/rows.h"

namespace desmo {

std::span<const Extreme> all_extremes() {
  using namespace extremes;
  static constexpr std::array table{
      Extreme{1, "long chains", "four-bars of no dyad to 1,000,000, of equal and unequal lengths",
              "position error ≤ 16 ε L K, and what rounding causes", &long_chains},
      Extreme{2, "near dead points", "slack of 1e-2 … 1e-12, within 1e-1 … 1e-5 rad",
              "10 times the floor that conditioning sets, at every level", &near_dead_points},
      Extreme{3, "singular positions",
              "a dead point and cranks in line, exactly; a Stewart platform turned by 90°",
              "flagged, always", &singular_positions},
      Extreme{4, "lock-up", "the third group cannot be closed from an instant on",
              "group and instant named, the rest right; goes on when it reopens", &lock_up},
      Extreme{5, "branches", "steps of 0.01 … 3 rad, starts from anywhere",
              "the declared branch or a failure", &branches},
      Extreme{6, "over-constrained", "mobile with a surplus; contradictory by 0.01",
              "converges, the redundancy reported; refused", &redundant},
      Extreme{7, "scales", "lengths × 1e±9, both in one model, × 1e±150",
              "4 times the error at scale 1, as many iterations ± 1 a step", &scales},
      Extreme{8, "long runs", "10⁶ steps, times up to 1e7 s",
              "at the end at most twice the error of the beginning", &long_runs},
      Extreme{
          9, "bad starts", "estimates 0, 10, 50, 200 % off",
          "the branch that the homotopy from it means, or a flag; an exact start is not made worse",
          &bad_starts},
      Extreme{10, "bad input", "NaN, infinities, lengths of zero; drivers that stop being numbers",
              "refused, or failed at that time with all earlier results right", &bad_input},
      Extreme{11, "reused pivots", "10,000 steps through a nearly singular position",
              "at most twice the error with new pivots each time", &reused_pivots},
      Extreme{12, "idle freedom", "a coupler between two spherical joints",
              "named; points right to 1e-13", &idle_freedom},
      Extreme{13, "tolerances", "1e-3 … 1e-16", "10 times the tolerance, or the floor",
              &tolerances},
      Extreme{14, "accuracy of estimates", "the estimates of condition and error themselves",
              "condition within a factor of 10; bounds above the error, by 1000 floors at most",
              &estimates},
      Extreme{15, "beside change points", "0 … 0.1 rad beside one; cranks of 1e-3 … 1e-9 links",
              "1000 times the tolerance, or the floor, or a flag", &change_points},
  };
  return table;
}

const Extreme& find_extreme(int number) {
  const auto it = std::ranges::find(all_extremes(), number, &Extreme::number);
  if (it == all_extremes().end())
    throw std::invalid_argument("there is no extreme " + std::to_string(number) +
                                "; they are 1 … " + std::to_string(all_extremes().size()));
  return *it;
}

}  // namespace desmo
