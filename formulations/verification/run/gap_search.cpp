#include "formulations/verification/run/gap_search.h"

#include <cmath>

#include "formulations/motion/internals.h"
#include "formulations/variants.h"
#include "formulations/verification/run/assembly_error.h"

namespace desmo {

namespace {

/// Width [s] of the bracket in which the search for an end of a gap stops.
constexpr double bracket = 1e-9;

/// Bisects between two times [s]: `good`, where the formulation is, and `bad`, where it fails.
/// Returns a time that can be solved, to within `bracket` of one that cannot.
double last_solved(Formulation& formulation, double good, double bad) {
  while (std::abs(bad - good) > bracket) {
    const double middle = good + (bad - good) / 2;
    if (middle == good || middle == bad) break;
    (formulation.step(middle, Level::position).ok() ? good : bad) = middle;
  }
  return good;
}

}  // namespace

std::optional<Misfit> assembly_error_at(const Formulation& formulation, double time) {
  const Model& m = formulation.model();
  std::vector<double> state = m.state_of(formulation.q());
  for (const Driver& d : m.drivers)
    state[m.entities[d.coordinate].first] = sample(d.motion, time).position;
  return find_assembly_error(m, std::move(state));
}

std::pair<Gap, int> find_gap(Formulation& formulation, const TimeGrid& grid, int failed,
                             const CheckedSummary& failure,
                             const std::function<bool(int)>& solves) {
  const double end = grid.time(grid.instants - 1);
  Gap gap{failure.time, end, false, Summary{failure}, failure.assembly_error, failure.table_lock};
  // A coarse tolerance accepts positions beyond a lock, so that the ends need one of their own.
  const std::unique_ptr<Formulation> exact =
      make_formulation(find_variant("group_automatic_lapack"), formulation.model());
  const auto follows = [&](int index) {
    return stepping_of(*exact).start_at(formulation.q(), grid.time(index));
  };
  int last = failed - 1;
  if (last >= 0 && !follows(last))
    while (last >= 0 && !exact->assemble(grid.time(last), Level::position).ok()) --last;
  if (last >= 0) gap.from = last_solved(*exact, grid.time(last), gap.from);
  int next = failed + 1;
  const auto assembled = [&] {
    return exact->assemble(grid.time(next), Level::position).ok() &&
           formulation.assemble(grid.time(next)).ok();
  };
  bool is_led = false;
  while (next < grid.instants && !(is_led = solves(next)) && !assembled()) ++next;
  gap.ends = next < grid.instants;
  if (is_led) follows(next);
  if (gap.ends) gap.to = last_solved(*exact, grid.time(next), grid.time(next - 1));
  return {gap, next};
}

}  // namespace desmo
