#include "bench/experiments/extremes/floor.h"

#include <algorithm>
#include <cmath>

namespace desmo::extremes {

PerLevel<double> floor_at(const Model& m, std::span<const double> q, double condition) {
  const double size = nominal_size(m);
  double driven = 1;
  for (const Driver& d : m.drivers) {
    const Entity& e = m.entities[d.coordinate];
    driven = std::max(driven, std::abs(q[e.first]) / (is_length(e.kind) ? size : 1));
  }
  PerLevel<double> floor = accuracy_limit(std::max(1.0, condition), std::ldexp(1, -53));
  for (const Level level : levels) floor[level] *= driven;
  return floor;
}

}  // namespace desmo::extremes
