// Row 4: from an instant on the third of four groups cannot be closed; later it can again.
#include "cases/extremes/rows.h"

namespace desmo::extremes {

namespace {

/// Returns a chain whose second dyad locks: it spans at most 10.5, and its ends would come to be up
/// to 11.3 apart.
DyadChain locking() {
  DyadChain chain = usual_chain(1, 0.25);
  add_dyad(chain, 12, 6, 4.5);
  add_dyad(chain, 17, 6, 6);
  return chain;
}

}  // namespace

std::vector<ExtremeCase> lock_up(Extent) {
  ExtremeCase stops = case_of("third group of four", locking(), 1, {0, 0.01, 600});
  stops.failing_body = "dyad2/rocker";
  ExtremeCase continued = stops;
  continued.name = "the same, until it has reopened, the ends to 1e-9 s";
  continued.past_failures = true;
  return {stops, continued};
}

}  // namespace desmo::extremes
