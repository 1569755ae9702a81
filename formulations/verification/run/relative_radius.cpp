#include "formulations/verification/run/relative_radius.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace desmo {

namespace {

/// The largest radius of one kind at a level.
struct Largest {
  double squares = 0;  // of the components
  GroupId group = no_position;
};

}  // namespace

RelativeRadius relative_radius(const Model& m, const PerLevel<std::span<const double>>& radius,
                               const Scales& scales) {
  constexpr double above = 1 + 0x1p-48;  // covers the few roundings of a norm, and of a ratio
  RelativeRadius result;
  for (const Level level : all_levels) {
    if (radius[level].empty()) continue;
    const double* const r = radius[level].data();
    std::array<Largest, 2> rotation_and_length;
    for (const Entity& e : m.entities) {
      if (e.fixed) continue;
      double squares = 0;
      for (int i = e.first; i < e.first + e.size; ++i) squares += r[i] * r[i];
      Largest& largest = rotation_and_length[is_length(e.kind)];
      // Infinite: unproven, or of a level that is not solved.
      if (squares > largest.squares && squares < INFINITY) largest = {squares, e.group};
    }
    for (const bool lengths : {false, true}) {
      const auto& [squares, group] = rotation_and_length[lengths];
      const double own = std::sqrt(squares) * above;
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
