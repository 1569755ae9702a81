#include "bench/experiments/extremes/comparison.h"

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "formulations/verification/error.h"

namespace desmo::extremes {

namespace {

void turn_back(const Model& m, std::span<const double> right, std::vector<double>& q) {
  constexpr double turn = 2 * std::numbers::pi;
  for (const Entity& e : m.entities)
    if (e.kind == EntityKind::angle && !e.fixed)
      q[e.first] -= turn * std::nearbyint((q[e.first] - right[e.first]) / turn);
}

}  // namespace

PerLevel<double> error_of(const Instant& instant, const Problem& problem, std::size_t of,
                          std::size_t next) {
  const Answers& answers = problem.answers[of];
  const ReferenceInstant& right = answers.right[next];
  const auto part = [&](std::span<const double> whole) {
    std::vector<double> values;
    for (const int i : answers.coordinate) values.push_back(whole[i]);
    return values;
  };
  std::vector<double> q = part(instant.q);
  if (const ExtremeCase& c = *problem.definition; c.starts || c.goes_on)
    turn_back(answers.model, right.q, q);
  const std::vector<double> qd = part(instant.qd), qdd = part(instant.qdd);
  ErrorMeasure measure(answers.model, {&right, 1}, answers.scales);
  measure.observe({0, right.time, q, qd, qdd});
  const Error e = measure.error();
  return {e.position.max, e.velocity.max, e.acceleration.max};
}

}  // namespace desmo::extremes
