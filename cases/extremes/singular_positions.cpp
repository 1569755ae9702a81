// Row 3: positions in which the equations are singular to the last bit. Lengths, pivots and the
// angle 0 are numbers that binary floating point has.
#include "cases/extremes/rows.h"

namespace desmo::extreme {

namespace {

/// From -1 rad to 0, where it ends, in steps of 1/8.
ExtremeCase to_zero(std::string name, const DyadChain& chain) {
  return case_of(std::move(name), chain, 1, {0, 0.125, 9});
}

/// Coupler and rocker of 5 and 3 are stretched over 8.
DyadChain dead_point() {
  DyadChain chain{.crank = 2, .start = -1, .dyads = {}};
  chain.dyads = {closed_dyad(crank_pin(chain), {-6, 0, 0}, 5, 3, 1)};
  return chain;
}

/// The N-four-bar of the benchmark literature: parallel cranks one after the other, all of them in
/// one line at the end.
DyadChain aligned(int dyads) {
  DyadChain chain{.crank = 1, .start = -1, .dyads = {}};
  Description::Vec from = crank_pin(chain);
  for (int k = 1; k <= dyads; ++k) {
    chain.dyads.push_back(closed_dyad(from, {2.0 * k, 0, 0}, 2, 1, -1));
    from = chain.dyads.back().joint;
  }
  return chain;
}

}  // namespace

std::vector<ExtremeCase> singular_positions(Extent) {
  return {to_zero("dead point", dead_point()), to_zero("parallel cranks in line", aligned(1)),
          to_zero("8 parallel cranks in line", aligned(8))};
}

}  // namespace desmo::extreme
