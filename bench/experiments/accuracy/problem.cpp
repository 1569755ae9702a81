#include "bench/experiments/accuracy/problem.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace desmo::accuracy {

namespace {

/// One of each of count − 1 equal stretches of the grid, and its last; the first of them all. Where
/// in its stretch goes by multiples of the golden ratio, which fall everywhere: at regular
/// distances all might be multiples of a stride, where nothing is interpolated.
std::vector<double> spread(const TimeGrid& grid, int count) {
  const long last = grid.instants - 1, stretches = count - 1;
  std::vector<double> times;
  for (long i = 0; i < stretches; ++i) {
    const long begin = i * last / stretches, end = (i + 1) * last / stretches;
    const double turns = static_cast<double>(i) * std::numbers::phi;
    const double part = (turns - std::floor(turns)) * static_cast<double>(end - begin);
    times.push_back(grid.time(static_cast<int>(begin + static_cast<long>(part))));
  }
  times.push_back(grid.time(static_cast<int>(last)));
  return times;
}

}  // namespace

Problem make_problem(Plan plan, const TimeGrid& grid, int compared) {
  Reference reference = make_reference(plan.model, spread(grid, std::min(grid.instants, compared)));
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

}  // namespace desmo::accuracy
