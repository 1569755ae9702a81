#include "formulations/verification/reference/reference.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "formulations/motion/groupwise/double_solution.h"
#include "formulations/motion/groupwise/drawn_start.h"
#include "formulations/motion/groupwise/groupwise_solver.h"
#include "formulations/verification/reference/global_solver.h"
#include "formulations/verification/reference/wide_instant.h"

namespace desmo {

namespace {

/// Follows the motion in double precision and, at each of the times, solves it again in quadruple.
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

/// Returns the nearest doubles, and the remainders as doubles.
std::pair<std::vector<double>, std::vector<double>> split(const std::vector<Quadruple>& values) {
  std::pair<std::vector<double>, std::vector<double>> result;
  for (const Quadruple& x : values) {
    const auto high = static_cast<double>(x);
    result.first.push_back(high);
    result.second.push_back(static_cast<double>(x - high));
  }
  return result;
}

/// Returns the largest difference of two solutions' outputs at an instant, at one level, over the
/// scales.
double at_level(const Model& m, const std::vector<Quadruple>& a, const std::vector<Quadruple>& b,
                const Scales& scales, Level level) {
  double largest = 0;
  for (const Entity& e : m.entities) {
    if (e.fixed) continue;
    double output = 0;
    for (int i = e.first; i < e.first + e.size; ++i) {
      const auto difference = static_cast<double>(a[i] - b[i]);
      output = std::hypot(output, relative(difference, scales.of(e.kind, level)));
    }
    largest = std::max(largest, output);
  }
  return largest;
}

}  // namespace

ReferenceInstant rounded(const WideInstant& wide) {
  ReferenceInstant r{wide.time, {}, {}, {}};
  std::tie(r.q, r.remainder.q) = split(wide.q);
  std::tie(r.qd, r.remainder.qd) = split(wide.qd);
  std::tie(r.qdd, r.remainder.qdd) = split(wide.qdd);
  return r;
}

PerLevel<double> disagreement(const Model& m, std::span<const WideInstant> a,
                              std::span<const WideInstant> b, const Scales& scales) {
  PerLevel<double> largest;
  const auto raise = [&](Level level, const auto& x, const auto& y) {
    largest[level] = std::max(largest[level], at_level(m, x, y, scales, level));
  };
  for (std::size_t k = 0; k < a.size(); ++k) {
    raise(Level::position, a[k].q, b[k].q);
    raise(Level::velocity, a[k].qd, b[k].qd);
    raise(Level::acceleration, a[k].qdd, b[k].qdd);
  }
  return largest;
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
