// Row 4: from an instant on the third of four groups cannot be closed; later it can again.
#include <array>

#include "cases/extremes/rows.h"

namespace desmo::extremes {

namespace {

/// The second dyad reaches over 10.5, its ends are up to 11.3 apart.
DyadChain locking() {
  DyadChain chain = usual_chain(1, 0.25);
  for (const auto& [pivot, coupler, rocker] :
       {std::array{12.0, 6.0, 4.5}, std::array{17.0, 6.0, 6.0}})
    chain.dyads.push_back(closed_dyad(chain.dyads.back().joint, {pivot, 0, 0}, coupler, rocker, 1));
  return chain;
}

}  // namespace

std::vector<ExtremeCase> lock_up(Extent) {
  ExtremeCase stops = case_of("third group of four", locking(), 1, {0, 0.01, 600});
  stops.failing_body = "dyad2/rocker";
  ExtremeCase goes_on = stops;
  goes_on.name = "the same, until it has reopened, the ends to 1e-9 s";
  goes_on.goes_on = true;
  return {stops, goes_on};
}

}  // namespace desmo::extremes
