#include "formulations/reference.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "formulations/accuracy/disagreement.h"
#include "formulations/accuracy/global_solver.h"
#include "formulations/accuracy/groupwise_solver.h"

namespace desmo {

namespace {

/// Goes from an assembly at the first of the times to each in turn, no step longer than 10 ms.
/// step(t) follows the motion, arrive(t) is called after the steps that lead to one of the times.
template <class Step, class Arrive>
void walk(std::span<const double> times, Step&& step, Arrive&& arrive) {
  constexpr double longest_step = 0.01;
  double t = times.empty() ? 0 : times.front();
  for (const double target : times) {
    const int steps = std::max(1, static_cast<int>(std::ceil((target - t) / longest_step - 1e-9)));
    const double from = t;
    for (int i = 1; i <= steps; ++i) step(i == steps ? target : from + (target - from) * i / steps);
    arrive(t = target);
  }
}

/// Follows the motion in double precision and solves each of the times again in quadruple.
template <template <class> class Solver>
std::vector<WideInstant> quadruple_solution(const Mechanism& m, std::span<const double> times) {
  Solver<double> walker(m);
  Solver<Quadruple> solver(m);
  std::vector<WideInstant> result;
  walk(
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

ReferenceInstant rounded(const WideInstant& wide) {
  ReferenceInstant r{wide.time, {}, {}, {}};
  std::tie(r.q, r.rest.q) = split(wide.q);
  std::tie(r.qd, r.rest.qd) = split(wide.qd);
  std::tie(r.qdd, r.rest.qdd) = split(wide.qdd);
  return r;
}

}  // namespace

std::vector<ReferenceInstant> reference_solution(const Mechanism& m, std::span<const double> times,
                                                 Precision precision) {
  std::vector<ReferenceInstant> result;
  if (precision == Precision::quadruple) {
    for (const WideInstant& wide : quadruple_solution<GroupwiseSolver>(m, times))
      result.push_back(rounded(wide));
  } else {
    GroupwiseSolver<double> solver(m);
    walk(
        times, [&](double t) { solver.solve_positions(t); },
        [&](double t) {
          solver.solve_rates();
          result.push_back({t, solver.q(), solver.qd(), solver.qdd()});
        });
  }
  return result;
}

Reference make_reference(const Mechanism& m, std::span<const double> times) {
  const std::vector<WideInstant> groupwise = quadruple_solution<GroupwiseSolver>(m, times);
  const std::vector<WideInstant> global = quadruple_solution<GlobalSolver>(m, times);
  Reference r;
  for (const WideInstant& wide : groupwise) r.instants.push_back(rounded(wide));
  r.scales = make_scales(m, r.instants);
  r.floor = disagreement(m, groupwise, global, r.scales);
  return r;
}

}  // namespace desmo
