// A four-bar whose crank cannot make a full turn, its dead point, and the other branch of a dyad.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/mechanisms.h"

namespace desmo {

/// The crank angle of the dead point [rad], where coupler and rocker are in line. Lengths: crank 2
/// about (0, 0), coupler 3, rocker 6 about (8, 0).
inline const double dead_point = std::acos((4.0 + 64 - 81) / 32);

/// Returns the four-bar with C, the pin of coupler and rocker, above the line from B to D. crank:
/// motion of the crank angle, by default π/3 + t. The estimate is the position at t = 0.
inline Model locking_four_bar(const Motion& crank = Polynomial{{std::numbers::pi / 3, 1}}) {
  Model m = four_bar_model(1);
  m.drivers[0].motion = crank;
  for (Constraint& c : m.constraints)
    if (c.name.starts_with("dyad1/coupler")) c.constants[0] = 3 * 3;
  const auto place = [&](const char* name, double x, double y) {
    const Entity& e = m.entities[m.find(name)];
    double* at = (e.fixed ? m.fixed_values : m.estimate).data() + e.first;
    at[0] = x;
    if (e.size > 1) at[1] = y;
  };
  const double theta = sample(crank, 0.0).position;
  const double x = 2 * std::cos(theta), y = 2 * std::sin(theta);
  // C is `along` from B on the line to D, and `above` it.
  const double length = std::hypot(8 - x, y);
  const double along = (length * length + 9 - 36) / (2 * length);
  const double above = std::sqrt(std::max(0.0, 9 - along * along));
  const double ex = (8 - x) / length, ey = -y / length;
  const double cx = x + along * ex - above * ey, cy = y + along * ey + above * ex;
  place("dyad1/D", 8, 0);
  place("crank/theta", theta, 0);
  place("crank/B", x, y);
  place("dyad1/C", cx, cy);
  place("dyad1/psi", std::atan2(cy, cx - 8), 0);
  return m;
}

/// Mirrors the joint of a dyad at the line from the pin that it starts from to its pivot: the
/// position on the other branch. Its angle is the nearest there.
inline std::vector<double> on_other_branch(const Model& m, std::vector<double> q,
                                           const std::string& start, const std::string& dyad) {
  const auto at = [&](const std::string& name) { return m.value(name, q); };
  const std::string pivot = dyad + "/D", joint = dyad + "/C";
  const double bx = at(start + ".x"), by = at(start + ".y"), dx = at(pivot + ".x") - bx,
               dy = at(pivot + ".y") - by, cx = at(joint + ".x") - bx, cy = at(joint + ".y") - by;
  const double along = (cx * dx + cy * dy) / (dx * dx + dy * dy);
  const double x = bx + 2 * along * dx - cx, y = by + 2 * along * dy - cy;
  const double psi = std::atan2(y - at(pivot + ".y"), x - at(pivot + ".x"));
  q[m.coordinate(joint + ".x")] = x, q[m.coordinate(joint + ".y")] = y;
  double& angle = q[m.coordinate(dyad + "/psi")];
  angle += std::remainder(psi - angle, 2 * std::numbers::pi);
  return q;
}

}  // namespace desmo
