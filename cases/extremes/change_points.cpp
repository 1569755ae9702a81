// Row 15: a crank arrives at, leaves, touches or rests next to a change point. There coupler and
// rocker are stretched, and the joint may go on to either side.
#include <numbers>

#include "cases/extremes/rows.h"
#include "cases/mechanism/formatted.h"

namespace desmo::extremes {

namespace {

/// Makes a case next to the crank's angle θ = π. There coupler and rocker, of lengths 5 and 3, are
/// stretched: they span a distance of exactly 8.
/// - family: words for the way in which the crank moves
/// - distance: distance from θ = π [rad] at which the crank ends, starts, turns back or rests
ExtremeCase beside(const char* family, double distance, const Motion& crank, const TimeGrid& grid) {
  const DyadChain chain = one_dyad(2, sample(crank, grid.start).position, 6, 5, 3);
  ExtremeCase c =
      case_of(formatted("%s, %.0e rad beside, steps of 1/%.0f s", family, distance, 1 / grid.step),
              std::vector{chain}, {crank}, grid);
  c.may_fail = true;
  c.factor = 1000;  // wider than usual: runs in which rows are flagged may need it
  return c;
}

/// Makes a four-bar whose crank, of length 2 · scale, turns between links of 6.
ExtremeCase small_crank(double scale) {
  return may_fail(case_of(formatted("a crank %.0e as long as the links", scale / 3),
                          one_dyad(2 * scale, chain_start, 6, 6, 6), 1, {0, 0.125, 33}));
}

}  // namespace

std::vector<ExtremeCase> change_points(Extent extent) {
  constexpr double pi = std::numbers::pi;
  std::vector<ExtremeCase> all;
  for (const double d : {0.0, 1e-16, 1e-13, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2, 0.1}) {
    if (extent == Extent::brief && (d == 1e-16 || d == 1e-10 || d == 1e-6 || d == 1e-2)) continue;
    const TimeGrid grid{-1, 1. / 64, 65};
    all.push_back(beside("ends", d, Polynomial{{pi - d, 1}}, grid));
    all.push_back(beside("starts", d, Polynomial{{pi - d, -1}}, {0, 1. / 64, 65}));
    for (const int k : {64, 128, 1024})
      all.push_back(beside("turns back", d, HarmonicSum{pi - d - 0.25, {{0.25, pi, pi / 2}}},
                           {-1, 1. / k, 2 * k + 1}));
    all.push_back(beside("rests", d, Polynomial{{pi - d, 0, 0, 0, -1}}, {-1, 1. / 64, 129}));
  }
  for (const double scale : {1e-3, 1e-6, 1e-9}) all.push_back(small_crank(scale));
  return all;
}

}  // namespace desmo::extremes
