#include "formulations/verification/run/relative_radius.h"

#include <algorithm>
#include <cmath>

namespace desmo {

std::array<MaxNorm, 2> max_norms(const Model& m, std::span<const double> values) {
  std::array<MaxNorm, 2> result;  // norms are squared until the end
  for (const Entity& e : m.entities) {
    if (e.fixed) continue;
    double squares = 0;
    for (int i = e.first; i < e.first + e.size; ++i) squares += values[i] * values[i];
    MaxNorm& largest = result[is_length(e.kind)];
    if (squares > largest.norm && squares < INFINITY) largest = {squares, e.group};
  }
  for (auto& [norm, group] : result) norm = std::sqrt(norm);
  return result;
}

RelativeRadius relative_radius(const Model& m, const PerLevel<std::span<const double>>& radius,
                               const Scales& scales) {
  constexpr double above = 1 + 0x1p-48;  // covers the few roundings of a norm, and of a ratio
  RelativeRadius result;
  for (const Level level : all_levels) {
    if (radius[level].empty()) continue;
    // Infinite radii are unproven, or of a level that is not solved.
    const std::array<MaxNorm, 2> norms = max_norms(m, radius[level]);
    for (const bool lengths : {false, true}) {
      const auto& [norm, group] = norms[lengths];
      const double own = norm * above;
      (lengths ? result.length : result.rotation)[level] = own;
      const double scale = (lengths ? scales.length : scales.rotation)[level];
      if (scale == 0) continue;  // nothing has moved so far
      const double size = own / scale;
      result.largest[level] = std::max(result.largest[level], size);
      if (size > result.worst) result.worst = size, result.group = group;
    }
  }
  return result;
}

}  // namespace desmo
