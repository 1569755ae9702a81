#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "formulations/constraints/constraints.h"
#include "formulations/model/model.h"
#include "formulations/model/scales.h"

namespace desmo {

/// Returns whether a coupling reads an angle, so that whole turns count.
inline bool whole_turns_count(const Model& m) {
  const std::vector<bool> coupled = coupled_angles(m);
  return std::ranges::find(coupled, true) != coupled.end();
}

/// Maximum drift (≤) of a turn that leads back: distance of a coordinate from its first value,
/// relative to its nominal magnitude. Drift by rounding is smaller. The drift of a slow shaft,
/// while a fast one turns once, is larger.
inline constexpr double max_drift = 1e-9;

/// Returns whether two positions are the same for all equations, except for drivers and whole turns
/// of angles. Tables must be read at the same places, except for whole lengths of those that
/// repeat. The motion from one position to the other can then be repeated.
/// - from, to: coordinates or states
inline bool is_back(const Model& m, std::span<const double> from, std::span<const double> to) {
  constexpr double turn = 2 * std::numbers::pi;
  const std::vector<bool> driven = independent_coordinates(m);
  const std::vector<double> magnitude = nominal_magnitudes(m);
  for (const Entity& e : m.entities)
    for (int i = e.first; !e.fixed && !driven[e.first] && i < e.first + e.size; ++i) {
      const double moved = to[i] - from[i];
      const double drift = e.kind == EntityKind::angle ? std::remainder(moved, turn) : moved;
      if (!(std::abs(drift) <= max_drift * magnitude[i])) return false;
    }
  for (const Constraint& c : m.constraints) {
    if (c.kind != kind_index<TableCoupling>()) continue;
    const Entity& argument = m.entities[c.operands[1]];
    if (argument.fixed) continue;
    const auto table = [&c](int k) { return c.constants[TableCoupling::table + k].value; };
    const double length = table(3 + static_cast<int>(table(0))) - table(3);
    const double moved = c.constants[1].value * (to[argument.first] - from[argument.first]);
    const double drift = table(1) != 0 ? std::remainder(moved, length) : moved;
    if (!(std::abs(drift) <= max_drift * length)) return false;
  }
  return true;
}

/// Returns the coordinates that are angles neither driven nor coupled. Equations read their sines
/// and cosines, so whole turns do not matter.
inline std::vector<int> free_angles(const Model& m) {
  const std::vector<bool> driven = independent_coordinates(m), coupled = coupled_angles(m);
  std::vector<int> angles;
  for (std::size_t i = 0; i < m.entities.size(); ++i)
    if (const Entity& e = m.entities[i];
        !e.fixed && e.kind == EntityKind::angle && !driven[e.first] && !coupled[i])
      angles.push_back(e.first);
  return angles;
}

}  // namespace desmo
