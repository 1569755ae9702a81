#include "formulations/verification/reference/reference.h"

#include <tuple>
#include <utility>

#include "formulations/parts/groupwise/double_solution.h"
#include "formulations/parts/groupwise/drawn_start.h"
#include "formulations/parts/groupwise/groupwise_solver.h"
#include "formulations/verification/reference/disagreement.h"
#include "formulations/verification/reference/global_solver.h"

namespace desmo {

namespace {

/// Follows the motion in double precision and solves each of the times again in quadruple.
template <template <class> class Solver>
std::vector<WideInstant> quadruple_solution(const Model& m, std::span<const double> times) {
  Solver<double> walker(m);
  Solver<Quadruple> solver(m);
  if (!times.empty()) begin_on_drawn_branch(walker, m, times.front());
  std::vector<WideInstant> result;
  follow_motion(
      times, [&](double t) { walker.solve_positions(t); },
      [&](double t) {
        solver.start_at(walker);
        solver.solve_positions(t);
        solver.solve_rates();
        result.push_back({t, solver.q(), solver.qd(), solver.qdd()});
      });
  return result;
}

/// The nearest double, and what it leaves.
std::pair<std::vector<double>, std::vector<double>> split(const std::vector<Quadruple>& values) {
  std::pair<std::vector<double>, std::vector<double>> result;
  for (const Quadruple& x : values) {
    const auto high = static_cast<double>(x);
    result.first.push_back(high);
    result.second.push_back(static_cast<double>(x - high));
  }
  return result;
}

}  // namespace

ReferenceInstant rounded(const WideInstant& wide) {
  ReferenceInstant r{wide.time, {}, {}, {}};
  std::tie(r.q, r.remainder.q) = split(wide.q);
  std::tie(r.qd, r.remainder.qd) = split(wide.qd);
  std::tie(r.qdd, r.remainder.qdd) = split(wide.qdd);
  return r;
}

std::vector<ReferenceInstant> reference_solution(const Model& m, std::span<const double> times,
                                                 Precision precision) {
  if (precision == Precision::standard) return double_solution(m, times);
  std::vector<ReferenceInstant> result;
  for (const WideInstant& wide : quadruple_solution<GroupwiseSolver>(m, times))
    result.push_back(rounded(wide));
  return result;
}

Reference make_reference(const Model& m, std::span<const double> times) {
  const std::vector<WideInstant> groupwise = quadruple_solution<GroupwiseSolver>(m, times);
  const std::vector<WideInstant> global = quadruple_solution<GlobalSolver>(m, times);
  Reference r;
  for (const WideInstant& wide : groupwise) r.instants.push_back(rounded(wide));
  r.scales = make_scales(m, r.instants);
  r.floor = disagreement(m, groupwise, global, r.scales);
  return r;
}

}  // namespace desmo
