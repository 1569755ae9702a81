#include <utility>

#include "cases/extremes/rows.h"

namespace desmo::extremes {

ExtremeCase case_of(std::string name, std::vector<DyadChain> chains, std::vector<Motion> motions,
                    const TimeGrid& grid) {
  MechanismBuilder builder("dyad_chain", 2);
  builder.set_length_unit("1");
  for (const DyadChain& chain : chains) add(builder, chain);
  return {.name = std::move(name),
          .scene = {"dyad_chain", builder.release(), std::move(motions), grid},
          .chains = std::move(chains)};
}

ExtremeCase case_of(std::string name, const DyadChain& chain, double rate, const TimeGrid& grid) {
  return case_of(std::move(name), std::vector{chain}, {Polynomial{{chain.start, rate}}}, grid);
}

ExtremeCase may_fail(ExtremeCase c) {
  c.may_fail = true;
  return c;
}

void add_dyad(DyadChain& chain, double pivot, double coupler, double rocker, int side) {
  const Mechanism::Vec from = chain.dyads.empty() ? crank_pin(chain) : chain.dyads.back().joint;
  chain.dyads.push_back(closed_dyad(from, {pivot, 0, 0}, coupler, rocker, side));
}

DyadChain one_dyad(double crank, double start, double pivot, double coupler, double rocker,
                   int side) {
  DyadChain chain{.crank = crank, .start = start, .dyads = {}};
  add_dyad(chain, pivot, coupler, rocker, side);
  return chain;
}

DyadChain usual_chain(int dyads, double start, double scale) {
  DyadChain chain{.crank = 2 * scale, .start = start, .dyads = {}};
  chain.dyads.reserve(dyads);
  for (int k = 1; k <= dyads; ++k) add_dyad(chain, 6 * scale * k, 6 * scale, 6 * scale);
  return chain;
}

}  // namespace desmo::extremes
