#include "formulations/straight_way.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "cases/motion.h"

namespace desmo {

namespace {

/// The way is cut into so many pieces; a piece that cannot be solved is halved, down to the
/// shortest.
constexpr double longest_piece = 1.0 / 8, shortest_piece = 1.0 / 128;

/// Whole turns more do not make another way.
double shortest_way(const Mechanism& m, const Driver& d, double from, double to) {
  const double way = to - from;
  return m.entities[d.coordinate].kind == EntityKind::angle
             ? std::remainder(way, 2 * std::numbers::pi)
             : way;
}

}  // namespace

bool go_straight(const Mechanism& m, double t, State& state,
                 const std::function<bool(State&, std::span<const double> last)>& solve) {
  const std::size_t drivers = m.drivers.size();
  std::vector<double> from(drivers), way(drivers);
  for (std::size_t d = 0; d < drivers; ++d) {
    const Driver& driver = m.drivers[d];
    from[d] = state.q[m.entities[driver.coordinate].first];
    way[d] = shortest_way(m, driver, from[d], sample(driver.motion, t).position);
  }
  State reached = state;
  double done = 0, piece = 0;  // first where it is
  while (true) {
    for (std::size_t d = 0; d < drivers; ++d)
      state.q[m.entities[m.drivers[d].coordinate].first] = from[d] + (done + piece) * way[d];
    if (solve(state, reached.q)) {
      reached = state;
      done += piece;
      if (done >= 1) return true;
      piece = std::min(longest_piece, 1 - done);
    } else {
      state = reached;
      piece /= 2;
      if (piece < shortest_piece) return false;
    }
  }
}

}  // namespace desmo
