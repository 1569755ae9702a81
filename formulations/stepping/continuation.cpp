#include "formulations/stepping/continuation.h"

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

namespace {

using Solve = std::function<bool(State&, std::span<const double> last)>;

/// Moves the drivers by these changes. Returns false where that cannot be solved.
bool move_drivers(const Model& m, std::span<const double> changes, State& state,
                  const Solve& solve) {
  constexpr double max_step = 1.0 / continuation_steps, min_step = max_step / 16;
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

}  // namespace

bool continue_drivers_to(const Model& m, double t, State& state, const Solve& solve) {
  const State start = state;
  const std::vector<double> changes = driver_changes(m, start, t);
  if (move_drivers(m, changes, state, solve)) return true;
  std::vector<double> whole;  // where the short way is blocked, the long one may not be
  for (const Driver& d : m.drivers)
    whole.push_back(sample(d.motion, t).position - start.q[m.entities[d.coordinate].first]);
  if (whole == changes) return false;
  state = start;
  return move_drivers(m, whole, state, solve);
}

}  // namespace desmo
