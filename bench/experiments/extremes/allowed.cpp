#include "bench/experiments/extremes/allowed.h"

#include <algorithm>
#include <limits>

namespace desmo::extremes {

namespace {

/// Over all answers, of the first `count` instants that were compared.
PerLevel<double> max_errors(const Attempt& attempt, std::size_t count) {
  PerLevel<double> largest;
  for (const auto& of_part : attempt.errors)
    for (std::size_t i = 0; i < std::min(count, of_part.size()); ++i)
      for (const Level level : levels)
        if (of_part[i]) largest[level] = std::max(largest[level], (*of_part[i])[level]);
  return largest;
}

PerLevel<double> measured(const Problem& problem, const Attempt& attempt,
                          const Yardsticks& yardsticks) {
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  switch (problem.definition->bound) {
    case Bound::first_case:
      return yardsticks.first_case ? max_errors(*yardsticks.first_case, all) : PerLevel<double>{};
    case Bound::new_pivots:
      return yardsticks.new_pivots ? max_errors(*yardsticks.new_pivots, all) : PerLevel<double>{};
    case Bound::first_part:
      return max_errors(attempt, problem.compared.size() / 2);
    default:
      return {};
  }
}

}  // namespace

Allowed::Allowed(const Problem& problem, const Attempt& attempt, const Yardsticks& yardsticks)
    : problem_(problem), attempt_(attempt), measured_(measured(problem, attempt, yardsticks)) {}

double Allowed::operator()(Level level, std::size_t part, std::size_t next) const {
  const ExtremeCase& c = *problem_.definition;
  const Answers& answers = problem_.answers[part];
  const double floor = answers.floor[next][level];
  const bool is_position = level == Level::position;
  switch (c.bound) {
    case Bound::floor:
      return c.factor * floor;
    case Bound::length: {
      const double epsilon = std::numeric_limits<double>::epsilon();
      return (is_position ? c.factor * epsilon * answers.chain_length : 0) + 10 * floor;
    }
    case Bound::tolerance:
      return c.factor * std::max(c.scene.tolerance, floor);
    case Bound::fixed:
      return is_position ? c.factor : 10 * floor;
    case Bound::estimates:
      return attempt_.stated[next] ? attempt_.stated[next]->bound[level] : 0;
    case Bound::first_part:
      if (next < problem_.compared.size() / 2) return 10 * std::max(c.scene.tolerance, floor);
      [[fallthrough]];
    default:
      return std::max(c.factor * measured_[level], floor);
  }
}

}  // namespace desmo::extremes
