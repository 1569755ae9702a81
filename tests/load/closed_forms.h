// Closed forms of mechanisms in tests/load/scenes, with the motions of their files: each by its own
// geometry. Units are metres, radians and seconds; angles count whole turns.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "tests/library/geometry.h"

namespace desmo::load::closed_forms {

using namespace desmo::exact;

inline constexpr Real degree = pi / 180;

/// Numbers of a model by their names.
using Values = std::map<std::string, Jet>;

template <std::size_t D>
void add(Values& values, const std::string& name, const Vec<D>& x) {
  for (std::size_t i = 0; i < D; ++i) values[name + "." + "xyz"[i]] = x[i];
}

/// Returns c0 + c1 t + c2 t² degrees.
inline Jet degrees(double time, Real c0, Real c1, Real c2) {
  const Jet t = Jet::time(time);
  return Jet(degree) * (Jet(c0) + t * (Jet(c1) + Jet(c2) * t));
}

// At time t [s]. Gears, belts, racks, screws and mimic joints:
Values gear_train(double t);
Values planetary_gear(double t);
Values rack_steering(double t);
Values belt_arm(double t);
Values screw_jack(double t);
Values mimic_gripper(double t);
Values wound_drum(double t);
// Couplings by tables:
Values cam_dwell(double t);
Values indexing(double t);
Values curved_rail(double t);
// Without couplings:
Values excavator(double t);
Values guides(double t);

}  // namespace desmo::load::closed_forms
