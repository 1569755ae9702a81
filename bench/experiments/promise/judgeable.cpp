#include "bench/experiments/promise/judgeable.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "formulations/verification/assessment/limits.h"

namespace desmo::promise {

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
