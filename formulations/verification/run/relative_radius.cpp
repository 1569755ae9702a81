#include "formulations/verification/run/relative_radius.h"

#include <algorithm>
#include <cmath>

namespace desmo {

RelativeRadius relative_radius(const Model& m, const PerLevel<std::span<const double>>& radius,
                               const Scales& scales) {
  constexpr double above = 1 + 0x1p-48;  // covers the few roundings of a norm, and of a ratio
  RelativeRadius result;
  for (const Level level : all_levels)
    for (const Entity& e : m.entities) {
      if (e.fixed || radius[level].empty()) continue;
      double squares = 0;
      for (const double x : radius[level].subspan(e.first, e.size)) squares += x * x;
      if (!std::isfinite(squares)) continue;  // unproven, or of a level that is not solved
      const double own = std::sqrt(squares) * above;
      double& largest = (is_length(e.kind) ? result.length : result.rotation)[level];
      largest = std::max(largest, own);
      const double scale = scales.of(e.kind, level);
      if (scale == 0) continue;  // nothing has moved so far
      const double size = own / scale;
      result.largest[level] = std::max(result.largest[level], size);
      if (size > result.worst) result.worst = size, result.group = e.group;
    }
  return result;
}

}  // namespace desmo
