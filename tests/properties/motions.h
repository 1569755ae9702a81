#pragma once

#include <string>
#include <vector>

#include "cases/mechanism/motion.h"
#include "tests/random.h"

namespace desmo::properties {

/// A motion along a path of the drivers, from a base: u(t).
struct Profile {
  std::string name;
  enum { polynomial, harmonic, table } kind = polynomial;
  std::vector<double> values = {};  ///< coefficients; mean, amplitude, frequency, phase; at times
  std::vector<double> times = {};
  const char* ends = "natural";
  TimeGrid grid = {};
};

/// Returns a motion that is `distance` before a singular position at t = 0.
/// - side: −1 or 1, where the position lies
/// - length: of the way
Profile aimed_motion(Random& random, int instants, int side, double distance, double length);

/// Returns a motion between two path parameters. It begins at 0, where the drawing is, or anywhere.
Profile random_motion(Random& random, int instants, double low, double high);

/// Returns a motion at constant speed.
Profile straight_motion(Random& random, int instants, double from, double to);

/// Returns the motion of a driver as a scene file has it: base + direction u(t), in units of
/// 1 / unit.
std::string motion_text(const Profile& profile, double base, double direction, double unit);

}  // namespace desmo::properties
