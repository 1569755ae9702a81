#include "formulations/stepping/straight_way.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "cases/mechanism/motion.h"

namespace desmo {

namespace {

/// A piece that cannot be solved is halved, down to the shortest.
constexpr double max_piece = 1.0 / pieces_of_a_way, min_piece = max_piece / 16;

double min_way(const Model& m, const Driver& d, double from, double to) {
  const double way = to - from;
  return m.entities[d.coordinate].kind == EntityKind::angle
             ? std::remainder(way, 2 * std::numbers::pi)
             : way;
}

}  // namespace

std::vector<double> straight_way(const Model& m, const State& from, double t) {
  std::vector<double> way;
  for (const Driver& d : m.drivers)
    way.push_back(
        min_way(m, d, from.q[m.entities[d.coordinate].first], sample(d.motion, t).position));
  return way;
}

bool go_straight(const Model& m, double t, State& state,
                 const std::function<bool(State&, std::span<const double> last)>& solve) {
  const std::vector<double> way = straight_way(m, state, t);
  const State start = state;
  State reached = state;
  double done = 0, piece = 0;  // first where it is
  while (true) {
    for (std::size_t d = 0; d < way.size(); ++d) {
      const int driven = m.entities[m.drivers[d].coordinate].first;
      state.q[driven] = start.q[driven] + (done + piece) * way[d];
    }
    if (solve(state, reached.q)) {
      reached = state;
      done += piece;
      if (done >= 1) return true;
      piece = std::min(max_piece, 1 - done);
    } else {
      state = reached;
      piece /= 2;
      if (piece < min_piece) return false;
    }
  }
}

}  // namespace desmo
