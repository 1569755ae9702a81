#include "bench/experiments/size/problem.h"

#include <optional>
#include <utility>

#include "bench/kit/structure.h"
#include "bench/kit/verification.h"
#include "formulations/planning/plan.h"
#include "formulations/verification/reference/reference.h"

namespace desmo::size {

namespace {

/// Coordinates beyond which a reference in quadruple precision takes minutes.
constexpr int max_quadruple = 12'000;

std::vector<double> compared_times(const TimeGrid& grid) {
  const int last = grid.instants - 1;
  return {grid.time(0), grid.time(last / 2), grid.time(last)};
}

/// What the first entities need; nothing where none of them moves.
std::optional<Model> of_first_entities(const Model& whole, int count) {
  std::vector<Asked> asked;
  for (EntityId e = 0; e < count; ++e)
    if (!whole.rests(e)) asked.push_back({e, Level::acceleration});
  if (asked.empty()) return std::nullopt;
  return make_plan(whole, asked).model;
}

}  // namespace

Problem make_problem(Model m, const TimeGrid& grid, double tolerance) {
  const std::vector<double> times = compared_times(grid);
  if (m.coordinates() > max_quadruple) {
    auto reference = reference_solution(m, times, Precision::standard);
    return {std::move(m), grid, tolerance, std::move(reference), "double"};
  }
  Reference reference = make_reference(m, times);
  bench::require_agreement(m, reference.floor);
  return {std::move(m), grid, tolerance, std::move(reference.instants), "quadruple"};
}

Model cut_to(const Model& whole, int least) {
  // More entities never need less.
  int first = 1, last = static_cast<int>(whole.entities.size()) + 1;
  while (first < last) {
    const int middle = first + (last - first) / 2;
    const std::optional<Model> cut = of_first_entities(whole, middle);
    if (!cut || bench::moving_unknowns(*cut) < least)
      first = middle + 1;
    else
      last = middle;
  }
  const bool all = first > static_cast<int>(whole.entities.size());
  return all ? whole : *of_first_entities(whole, first);
}

}  // namespace desmo::size
