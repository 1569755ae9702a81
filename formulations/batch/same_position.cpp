#include "formulations/batch/same_position.h"

#include <algorithm>
#include <cmath>

namespace desmo {

namespace {

/// Beside the size of what differs.
constexpr double allowed_difference = 1e-6;

bool is_length(const Entity& e) {
  return e.kind == EntityKind::point || e.kind == EntityKind::distance;
}

}  // namespace

bool same_position(const Model& m, std::span<const double> a, std::span<const double> b) {
  double length = 0;
  for (const Entity& e : m.entities)
    for (int k = e.first; !e.fixed && is_length(e) && k < e.first + e.size; ++k)
      length = std::max(length, std::abs(b[k]));
  return std::ranges::all_of(m.entities, [&](const Entity& e) {
    const double allowed = allowed_difference * (is_length(e) ? length : 1);
    for (int k = e.first; !e.fixed && k < e.first + e.size; ++k)
      if (!(std::abs(a[k] - b[k]) <= allowed)) return false;
    return true;
  });
}

}  // namespace desmo
