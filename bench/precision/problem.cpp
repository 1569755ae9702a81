#include "bench/precision/problem.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace desmo::precision {

Problem make_problem(Plan plan, const TimeGrid& grid, int compared) {
  const long count = std::min(grid.instants, compared), last = grid.instants - 1;
  std::vector<double> times;
  for (long i = 0; i < count; ++i)
    times.push_back(grid.time(static_cast<int>(i * last / (count - 1))));
  Reference reference = make_reference(plan.mechanism, times);
  return {std::move(plan), grid, std::move(reference), {}};
}

TunedMotion make_tuned_motion(const Plan& plan, const TimeGrid& grid) {
  constexpr int begin_instants = 101;
  // Of most motions all: instants where the guess alone meets the tolerance may be rare.
  constexpr int compared = 1001;
  TimeGrid begin = grid;
  begin.instants = std::min(grid.instants, begin_instants);
  return {make_problem(plan, grid, compared), make_problem(plan, begin, begin_instants / 2)};
}

}  // namespace desmo::precision
