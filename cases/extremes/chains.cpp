#include <utility>

#include "cases/extremes/rows.h"

namespace desmo::extremes {

ExtremeCase case_of(std::string name, std::vector<DyadChain> chains, std::vector<Motion> motions,
                    const TimeGrid& grid) {
  MechanismBuilder d("dyad_chain", 2);
  d.set_length_unit("1");
  for (const DyadChain& chain : chains) add(d, chain);
  return {.name = std::move(name),
          .scene = {"dyad_chain", d.take(), std::move(motions), grid, {}, {}},
          .chains = std::move(chains)};
}

ExtremeCase case_of(std::string name, const DyadChain& chain, double rate, const TimeGrid& grid) {
  return case_of(std::move(name), std::vector{chain}, {Polynomial{{chain.start, rate}}}, grid);
}

DyadChain usual_chain(int dyads, double start, double scale) {
  DyadChain chain{.crank = 2 * scale, .start = start, .dyads = {}};
  chain.dyads.reserve(dyads);
  Mechanism::Vec from = crank_pin(chain);
  for (int k = 1; k <= dyads; ++k) {
    chain.dyads.push_back(closed_dyad(from, {6 * scale * k, 0, 0}, 6 * scale, 6 * scale, 1));
    from = chain.dyads.back().joint;
  }
  return chain;
}

}  // namespace desmo::extremes
