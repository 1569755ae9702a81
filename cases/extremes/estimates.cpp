// Row 14: cases of other rows, in which the stated condition and error bounds are checked, and two
// in which hardly any signal shows them.
#include <algorithm>
#include <iterator>
#include <numbers>
#include <vector>

#include "cases/extremes/rows.h"
#include "cases/io/files.h"

namespace desmo::extremes {

namespace {

/// In small steps, by which the condition number grows a thousandfold.
ExtremeCase approaching_a_dead_point() {
  const DyadChain chain = one_dyad(2, std::numbers::pi - 0.5, 6, 5, 3 + 1e-10);
  return case_of("approaching a dead point", chain, 0.5, {0, 0.002, 501});
}

/// Parallel cranks go on parallel where the other branch is the declared one: the joint changes
/// sides when they are in line, which their rates do not tell.
ExtremeCase through_a_change_point() {
  ExtremeCase c =
      case_of("through a change point", one_dyad(1, -1.0003, 2, 2, 1, -1), 1, {0, 0.001, 3001});
  c.settings = "/guess:quadratic";
  c.may_fail = true;
  return c;
}

}  // namespace

std::vector<ExtremeCase> estimates(Extent extent) {
  std::vector<ExtremeCase> all = near_dead_points(extent);
  all.push_back(approaching_a_dead_point());
  std::ranges::move(tolerances(extent), std::back_inserter(all));
  for (ExtremeCase& c : reused_pivots(extent))
    if (!c.settings.empty()) all.push_back(c);
  for (const char* name : {"andrews", "delta", "rssr", "stewart"})
    all.push_back({.name = name, .scene = library_scene(name)});
  for (ExtremeCase& c : all) {
    c.bound = Bound::estimates;
    c.factor = 1000;
  }
  all.push_back(through_a_change_point());
  return all;
}

}  // namespace desmo::extremes
