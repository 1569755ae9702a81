#pragma once

#include <cmath>
#include <limits>

namespace desmo {

/// Limits of find_range(). Lengths are arcs of a curve of positions, in rad or characteristic
/// lengths (*scaled*). tests/range/limits.cpp shows what goes wrong where one is ten times smaller
/// or larger; of max_correction, where it is smaller.
struct RangeLimits {
  /// Accuracy of the driver's values [scaled]: an end has |beyond − value| < accuracy, and values
  /// no further apart are one. Steps end at it, too: no step is shorter.
  double accuracy = 1e-9;

  /// Longest step [scaled]: length ≤ max_step. Signs of determinants and the driver's direction are
  /// looked at once a step: two changes in one step are not seen.
  double max_step = 0.1;

  /// Largest first correction of a step, over its length: |Δ₁| ≤ max_correction × length. It is
  /// about half the angle that the curve turns by. On another branch of a crossing it is larger.
  double max_correction = 0.1;

  /// Longest step [scaled] in which a change of a sign is a crossing: length ≤ max_crossing_step.
  /// Across a wider gap between two branches it is a jump. Rounding opens gaps of √u.
  double max_crossing_step = 1e-6;

  /// Size of a scaled determinant at points between which its root is interpolated. Points nearer
  /// to a singular position are not well known; a polynomial through farther ones is not exact.
  double sample_determinant = 1e-4;

  /// Number of steps that are tried in one direction: step < max_steps.
  int max_steps = 100'000;

  /// Return distances [scaled] of such points from a crossing and from a double root.
  double crossing_distance() const { return sample_determinant; }
  double double_root_distance() const { return std::sqrt(sample_determinant); }

  /// Returns the arc within which loops lock together, or a determinant without a change of sign
  /// counts as zero. The driver's values differ there by about its square.
  double locking_arc() const { return std::sqrt(accuracy); }
};

/// Half of all digits, √u. A driver of a smaller speed rests: its value is off that at the dead
/// point by about the square. Tangents that differ by more have lost half of their digits.
inline const double half_digits = std::sqrt(std::numeric_limits<double>::epsilon());

}  // namespace desmo
