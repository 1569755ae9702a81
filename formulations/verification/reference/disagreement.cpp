#include "formulations/verification/reference/disagreement.h"

#include <algorithm>
#include <cmath>

namespace desmo {

namespace {

double at_level(const Model& m, const std::vector<Quadruple>& a, const std::vector<Quadruple>& b,
                const Scales& scales, Level level) {
  double largest = 0;
  for (const Entity& e : m.entities) {
    if (e.fixed) continue;
    double output = 0;
    for (int i = e.first; i < e.first + e.size; ++i) {
      const auto difference = static_cast<double>(a[i] - b[i]);
      output = std::hypot(output, relative(difference, scales.of(e.kind, level)));
    }
    largest = std::max(largest, output);
  }
  return largest;
}

}  // namespace

PerLevel<double> disagreement(const Model& m, std::span<const WideInstant> a,
                              std::span<const WideInstant> b, const Scales& scales) {
  PerLevel<double> largest;
  const auto raise = [&](Level level, const auto& x, const auto& y) {
    largest[level] = std::max(largest[level], at_level(m, x, y, scales, level));
  };
  for (std::size_t k = 0; k < a.size(); ++k) {
    raise(Level::position, a[k].q, b[k].q);
    raise(Level::velocity, a[k].qd, b[k].qd);
    raise(Level::acceleration, a[k].qdd, b[k].qdd);
  }
  return largest;
}

}  // namespace desmo
