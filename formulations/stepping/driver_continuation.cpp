#include "formulations/stepping/driver_continuation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "cases/mechanism/motion.h"

namespace desmo {

std::vector<double> driver_changes(const Model& m, const State& from, double t) {
  std::vector<double> changes;
  for (const Driver& d : m.drivers) {
    const Entity& driven = m.entities[d.coordinate];
    const double change = sample(d.motion, t).position - from.q[driven.first];
    changes.push_back(
        driven.kind == EntityKind::angle ? std::remainder(change, 2 * std::numbers::pi) : change);
  }
  return changes;
}

bool continue_drivers_to(const Model& m, double t, State& state,
                         const std::function<bool(State&, std::span<const double> last)>& solve) {
  constexpr double max_step = 1.0 / continuation_steps, min_step = max_step / 16;
  const std::vector<double> changes = driver_changes(m, state, t);
  const State start = state;
  State reached = state;
  double done = 0, step = 0;  // first where it is
  while (true) {
    for (std::size_t d = 0; d < changes.size(); ++d) {
      const int driven = m.entities[m.drivers[d].coordinate].first;
      state.q[driven] = start.q[driven] + (done + step) * changes[d];
    }
    if (solve(state, reached.q)) {
      reached = state;
      done += step;
      if (done >= 1) return true;
      step = std::min(max_step, 1 - done);
    } else {
      state = reached;
      step /= 2;
      if (step < min_step) return false;
    }
  }
}

}  // namespace desmo
