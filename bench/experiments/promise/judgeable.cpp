#include "bench/experiments/promise/judgeable.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "formulations/verification/assessment/chosen_equations.h"
#include "formulations/verification/assessment/limits.h"
#include "formulations/verification/monitor/branch_monitor.h"
#include "formulations/verification/reference/global_solver.h"

namespace desmo::promise {

namespace {

ReferenceInstant rounded(double time, const GlobalSolver<Quadruple>& solver) {
  ReferenceInstant r{time, {}, {}, {}};
  const auto split = [](const std::vector<Quadruple>& values, std::vector<double>& high,
                        std::vector<double>& low) {
    for (const Quadruple& x : values) {
      high.push_back(static_cast<double>(x));
      low.push_back(static_cast<double>(x - high.back()));
    }
  };
  split(solver.q(), r.q, r.remainder.q);
  split(solver.qd(), r.qd, r.remainder.qd);
  split(solver.qdd(), r.qdd, r.remainder.qdd);
  return r;
}

/// Returns no q where the equations kept are as good as others. Those of a mechanism far from the
/// origin contradict each other wherever it is.
ReferenceInstant with_other_equations(const Model& given, const TrueInstant& t) {
  const auto model = with_chosen_equations(given, t.instant.q);
  if (!model) return {t.instant.time, {}, {}, {}};
  GlobalSolver<Quadruple> solver(*model);
  std::vector<Jet<Quadruple>> state = solver.state();
  for (std::size_t i = 0; i < t.instant.q.size(); ++i) state[i].value = t.instant.q[i];
  solver.restore(state);
  solver.solve_positions(t.instant.time);
  solver.solve_rates();
  return rounded(t.instant.time, solver);
}

}  // namespace

void add_other_answers(DrawnScene& scene) {
  constexpr double tolerance = 1e-12;
  BranchMonitor others(scene.model, {}, tolerance);
  for (TrueInstant& t : scene.truth) {
    scene.other_answers.push_back({t.instant.time, {}, {}, {}});
    if (!has_answer(t)) continue;
    const auto& [time, q, qd, qdd, remainder] = t.instant;
    if (others.violated({.index = 0, .time = time, .q = q, .qd = qd, .qdd = qdd}, true) >= 0)
      t.instant.q.clear();
    else
      scene.other_answers.back() = with_other_equations(scene.model, t);
  }
}

bool has_answer(const TrueInstant& t) { return !t.instant.q.empty(); }

PerLevel<double> floor_of(const TrueInstant& t) { return accuracy_limit(t.condition, 1e-32); }

bool is_regular(const DrawnScene& scene, int from, int to) {
  for (int i = std::max(from, 0); i <= std::min<int>(to, std::ssize(scene.truth) - 1); ++i) {
    const TrueInstant& t = scene.truth[i];
    const double condition = i == from ? t.condition : std::max(t.condition, t.path_condition);
    if (!has_answer(t) || condition * scene.rounding >= VerdictLimits::well_conditioned)
      return false;
  }
  return true;
}

int decided_until(const DrawnScene& scene, bool is_single) {
  const int instants = static_cast<int>(std::ssize(scene.truth));
  for (int i = 0; i < instants; ++i) {
    const TrueInstant& t = scene.truth[i];
    if (is_single &&
        std::max(t.condition, i > 0 ? t.path_condition : 0) > VerdictLimits::undecided_single)
      return i;
    const double ends = std::max(t.condition, i > 0 ? scene.truth[i - 1].condition : 0);
    if (i > 0 &&
        t.path_condition >
            std::max(VerdictLimits::undecided, VerdictLimits::nearer_between * ends) &&
        t.path_condition < INFINITY)
      return i;
  }
  return instants;
}

}  // namespace desmo::promise
