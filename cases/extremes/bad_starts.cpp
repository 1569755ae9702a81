// Row 9: initial estimates that are exact, or far off.
#include <string>

#include "cases/extremes/rows.h"
#include "cases/io/files.h"
#include "cases/mechanism/formatted.h"

namespace desmo::extremes {

namespace {

constexpr TimeGrid only_start{0, 1, 1};

ExtremeCase off_by(ExtremeCase c, double off, int count) {
  c.name += formatted(", %g %% off", 100 * off);
  c.starts = {count, off};
  c.may_fail = off > 0;  // an exact start must give the answer
  return c;
}

}  // namespace

std::vector<ExtremeCase> bad_starts(Extent extent) {
  const int count = extent == Extent::brief ? 50 : 2000;
  std::vector<ExtremeCase> all;
  for (const int dyads : {1, 3}) {
    const ExtremeCase chain = case_of("four-bar, K = " + std::to_string(dyads),
                                      usual_chain(dyads, chain_start), 1, only_start);
    all.push_back(off_by(chain, 0, 1));
    for (const double off : {0.1, 0.5, 2.0}) all.push_back(off_by(chain, off, count));
  }
  for (const char* name : {"andrews", "stewart"}) {
    ExtremeCase c{.name = name, .scene = library_scene(name)};
    c.scene.grid = only_start;
    all.push_back(off_by(c, 0.1, count));
  }
  return all;
}

}  // namespace desmo::extremes
