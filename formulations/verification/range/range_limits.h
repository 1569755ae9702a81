#pragma once

#include <cmath>
#include <limits>

namespace desmo {

/// Limits of find_range(). Lengths are arcs of a curve of positions, in rad or characteristic
/// lengths (*scaled*). The tests in tests/range/limits.cpp show what goes wrong if one is ten times
/// smaller or larger; for max_correction, if it is smaller.
struct RangeLimits {
  /// Accuracy of the driver's values [scaled]. A dead point has |beyond − value| < accuracy. Values
  /// with a smaller difference are equal. Steps are not halved to less than it.
  double accuracy = 1e-9;

  /// Longest step [scaled]: length ≤ max_step. Signs of determinants and the driver's direction are
  /// compared once a step, so that two changes of a sign in one step are not seen.
  double max_step = 0.1;

  /// Largest first correction of a step over its length: |Δ₁| ≤ max_correction × length. The ratio
  /// is about half the angle [rad] by which the curve turns; towards another branch of a crossing
  /// it is larger.
  double max_correction = 0.1;

  /// Longest step [scaled] in which a change of a sign counts as a crossing: length ≤
  /// max_crossing_step. Rounding opens gaps of about √u between branches that cross; a step across
  /// a wider gap is a jump to another branch.
  double max_crossing_step = 1e-6;

  /// Size of a scaled determinant at the points from which its root is interpolated. Points nearer
  /// to a singular position are not well known; a polynomial through farther points is not exact.
  double sample_determinant = 1e-4;

  /// Maximum number of steps that are tried in one direction.
  int max_steps = 100'000;

  /// Return the distances [scaled] from a crossing and from a double root at which a determinant
  /// has about the size sample_determinant: it is linear or quadratic in the distance.
  double crossing_distance() const { return sample_determinant; }
  double double_root_distance() const { return std::sqrt(sample_determinant); }

  /// Returns the arc [scaled] within which loops lock at once, and within which a determinant
  /// without a change of sign counts as zero. From a dead point, the driver's value changes along
  /// it by about its square, the accuracy.
  double locking_arc() const { return std::sqrt(accuracy); }
};

/// Half of all digits, √ε with ε = 2⁻⁵². A driver with |speed| < half_digits rests: its value
/// differs from that at the dead point by about the square. Two tangents of one point that differ
/// by more are tangents of two curves that cross.
inline const double half_digits = std::sqrt(std::numeric_limits<double>::epsilon());

}  // namespace desmo
