#include "formulations/motion/driver_continuation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "formulations/model/whole_turns.h"

namespace desmo {

std::vector<double> driver_changes(const Model& m, const State& from, const State& to) {
  const bool turns_count = whole_turns_count(m);
  std::vector<double> changes;
  for (const Driver& d : m.drivers) {
    const Entity& driven = m.entities[d.coordinate];
    const double change = to.q[driven.first] - from.q[driven.first];
    const bool is_shortened = driven.kind == EntityKind::angle && !turns_count;
    changes.push_back(is_shortened ? std::remainder(change, 2 * std::numbers::pi) : change);
  }
  return changes;
}

int continuation_steps(const Model& m, std::span<const double> changes, bool are_short) {
  constexpr int usual = 8;  // number of steps (≥), more where drivers turn far
  // maximum turn of a driver in a step [rad], so that Newton's method stays on its branch
  constexpr double max_turn = 0.1;
  if (!are_short && !whole_turns_count(m)) return usual;
  double largest = 0;
  for (std::size_t d = 0; d < changes.size(); ++d)
    if (m.entities[m.drivers[d].coordinate].kind == EntityKind::angle)
      largest = std::max(largest, std::abs(changes[d]));
  return std::max(usual, static_cast<int>(std::ceil(std::min(largest / max_turn, 1e9))));
}

namespace {

using Solve = std::function<bool(State&, std::span<const double> last)>;

/// Moves the drivers by these changes. Returns false where that cannot be solved.
bool move_drivers(const Model& m, std::span<const double> changes, State& state, const Solve& solve,
                  bool are_short = false) {
  const double max_step = 1.0 / continuation_steps(m, changes, are_short), min_step = max_step / 16;
  const State start = state;
  State reached = state;
  double done = 0, step = 0;  // shares of the changes; 0: the first solve is at the start
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

/// Takes whole turns that lead back (is_back()) off the drivers' changes, and adds them to the
/// angles of the state instead.
void leave_out_turns(const Model& m, std::vector<double>& changes, State& state,
                     const Solve& solve) {
  constexpr double turn = 2 * std::numbers::pi;
  std::vector<double> way(changes.size());
  if (!move_drivers(m, way, state, solve)) return;
  for (std::size_t d = 0; d < changes.size(); ++d) {
    const double turns = std::trunc(std::abs(changes[d]) / turn);
    if (m.entities[m.drivers[d].coordinate].kind != EntityKind::angle || turns < 2) continue;
    State moved = state;
    way[d] = std::copysign(turn, changes[d]);
    const bool leads_back = move_drivers(m, way, moved, solve) && is_back(m, state.q, moved.q);
    const double made = std::exchange(way[d], 0);
    if (!leads_back) continue;
    changes[d] -= turns * made;
    for (const Entity& e : m.entities)
      if (!e.fixed && e.kind == EntityKind::angle)
        state.q[e.first] += turns * turn * std::round((moved.q[e.first] - state.q[e.first]) / turn);
  }
}

}  // namespace

ContinuationEnd continue_drivers_to(const Model& m, const State& to, State& state,
                                    const Solve& solve, bool are_short) {
  const State start = state;
  std::vector<double> changes = driver_changes(m, start, to);
  if (continuation_steps(m, changes) > max_continuation_steps)
    leave_out_turns(m, changes, state, solve);
  if (continuation_steps(m, changes) > max_continuation_steps) return ContinuationEnd::too_long;
  if (move_drivers(m, changes, state, solve, are_short)) return ContinuationEnd::reached;
  std::vector<double> whole;  // changes with whole turns: that way may be free
  for (const Driver& d : m.drivers) {
    const int driven = m.entities[d.coordinate].first;
    whole.push_back(to.q[driven] - start.q[driven]);
  }
  if (whole == changes || continuation_steps(m, whole, are_short) > max_continuation_steps)
    return ContinuationEnd::blocked;
  state = start;
  return move_drivers(m, whole, state, solve, are_short) ? ContinuationEnd::reached
                                                         : ContinuationEnd::blocked;
}

}  // namespace desmo
