#include "formulations/motion/driver_continuation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "cases/mechanism/motion.h"

namespace desmo {

bool whole_turns_count(const Model& m) {
  const std::vector<bool> coupled = coupled_angles(m);
  return std::ranges::find(coupled, true) != coupled.end();
}

std::vector<double> driver_changes(const Model& m, const State& from, double t) {
  const bool turns_count = whole_turns_count(m);
  std::vector<double> changes;
  for (const Driver& d : m.drivers) {
    const Entity& driven = m.entities[d.coordinate];
    const double change = sample(d.motion, t).position - from.q[driven.first];
    const bool is_shortened = driven.kind == EntityKind::angle && !turns_count;
    changes.push_back(is_shortened ? std::remainder(change, 2 * std::numbers::pi) : change);
  }
  return changes;
}

int continuation_steps(const Model& m, std::span<const double> changes) {
  constexpr int usual = 8;
  constexpr double max_turn = 0.1;  // [rad], of a driver, so that Newton stays on its branch
  if (!whole_turns_count(m)) return usual;
  double largest = 0;
  for (std::size_t d = 0; d < changes.size(); ++d)
    if (m.entities[m.drivers[d].coordinate].kind == EntityKind::angle)
      largest = std::max(largest, std::abs(changes[d]));
  return std::max(usual, static_cast<int>(std::ceil(std::min(largest / max_turn, 1e9))));
}

namespace {

using Solve = std::function<bool(State&, std::span<const double> last)>;

/// Moves the drivers by these changes. Returns false where that cannot be solved.
bool move_drivers(const Model& m, std::span<const double> changes, State& state,
                  const Solve& solve) {
  const double max_step = 1.0 / continuation_steps(m, changes), min_step = max_step / 16;
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
