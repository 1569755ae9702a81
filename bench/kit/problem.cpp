#include "bench/kit/problem.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "formulations/model/partition.h"

namespace desmo::bench {

namespace {

/// Number of coordinates above which (>) a reference in quadruple precision takes minutes.
constexpr int max_quadruple = 12'000;

}  // namespace

Problem make_problem(Plan plan, const TimeGrid& grid, int compared) {
  Reference reference =
      make_reference(plan.model, spread_times(grid, std::min(grid.instants, compared)));
  return {.plan = std::move(plan), .grid = grid, .reference = std::move(reference)};
}

Problem make_problem(Model m, const TimeGrid& grid, double tolerance) {
  const int last = grid.instants - 1;
  const std::vector<double> times{grid.time(0), grid.time(last / 2), grid.time(last)};
  Problem p{.plan = {}, .grid = grid, .tolerance = tolerance};
  if (m.coordinates() > max_quadruple) {
    p.reference.instants = reference_solution(m, times, Precision::standard);
    p.checked_against = "double";
  } else {
    p.reference = make_reference(m, times);
    require_agreement(m, p.reference.floor);
  }
  p.plan.model = std::move(m);
  return p;
}

int moving_unknowns(const Model& m) {
  std::size_t unknowns = 0;
  for (const PartDefinition& part : make_partition(m, Partition::group))
    if (!part.constant) unknowns += part.unknowns.size();
  return static_cast<int>(unknowns);
}

}  // namespace desmo::bench
