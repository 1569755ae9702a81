// Row 1: growth of the error with the number of groups.
#include <cmath>
#include <string>

#include "cases/extremes/rows.h"

namespace desmo::extremes {

namespace {

/// Makes a chain of parallelograms: each coupler is as long as its pivots are apart, which differs
/// from dyad to dyad. All rockers stay parallel, so that any number of dyads can follow.
DyadChain unequal(int dyads) {
  DyadChain chain{.crank = 2, .start = chain_start, .dyads = {}};
  double pivot = 0;
  for (int k = 1; k <= dyads; ++k) {
    const double length = k == 1 ? 6 : 6 + 2.5 * std::sin(k);
    pivot += length;
    add_dyad(chain, pivot, length, 6);
  }
  return chain;
}

/// Ten steps over 1.5 s, in which the crank turns by 1.5 rad.
constexpr TimeGrid long_chain_grid{0, 0.15, 11};

ExtremeCase chain_case(const std::string& lengths, const DyadChain& chain) {
  ExtremeCase c = case_of("K = " + std::to_string(chain.dyads.size()) + ", " + lengths, chain, 1,
                          long_chain_grid);
  c.bound = Bound::length;
  c.factor = 16;
  c.scene.tolerance = 1e-16;  // below rounding, which then ends the iteration
  return c;
}

ExtremeCase nothing_moves() {
  MechanismBuilder builder("ground", 2);
  builder.set_length_unit("1");
  builder.carry(MechanismBuilder::ground,
                {builder.point("A", {0, 0, 0}), builder.point("B", {1, 0, 0})});
  ExtremeCase c{.name = "no group", .scene = {"ground", builder.release(), {}, long_chain_grid}};
  c.is_refused = true;  // there is no unknown
  return c;
}

}  // namespace

std::vector<ExtremeCase> long_chains(Extent extent) {
  std::vector<ExtremeCase> all{nothing_moves()};
  for (const int dyads : {0, 1, 10, 100, 1000})
    all.push_back(chain_case("equal", usual_chain(dyads, chain_start)));
  for (const int dyads : {10, 1000}) all.push_back(chain_case("unequal", unequal(dyads)));
  if (extent == Extent::brief) return all;
  for (const int dyads : {10'000, 100'000, 1'000'000})
    all.push_back(chain_case("equal", usual_chain(dyads, chain_start)));
  all.push_back(chain_case("unequal", unequal(100'000)));
  for (ExtremeCase& c : all)
    if (c.chains.size() == 1 && c.chains.front().dyads.size() > 10'000) c.scene.grid.instants = 3;
  return all;
}

}  // namespace desmo::extremes
