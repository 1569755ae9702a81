#include "formulations/motion/groupwise/double_solution.h"

#include "formulations/motion/groupwise/drawn_start.h"
#include "formulations/motion/groupwise/groupwise_solver_impl.h"

namespace desmo {

template class GroupwiseSolver<double>;

std::vector<ReferenceInstant> double_solution(const Model& m, std::span<const double> times) {
  std::vector<ReferenceInstant> result;
  GroupwiseSolver<double> solver(m);
  if (!times.empty()) begin_on_drawn_branch(solver, m, times.front());
  follow_motion(
      times, [&](double t) { solver.solve_positions(t); },
      [&](double t) {
        solver.solve_rates();
        result.push_back({t, solver.q(), solver.qd(), solver.qdd()});
      });
  return result;
}

}  // namespace desmo
