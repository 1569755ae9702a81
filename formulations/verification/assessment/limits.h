#pragma once

#include <algorithm>
#include <limits>

#include "formulations/base/per_level.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/condition.h"

namespace desmo {

/// Returns the error limits (factor t, factor² t, factor³ t) of position, velocity and
/// acceleration, t being the tolerance of position. Each level loses what a moderate condition
/// number costs. No limit is above half a scale: a larger error leaves no digit.
inline PerLevel<double> powers(double factor, double tolerance) {
  constexpr double no_digit = 0.5;
  const double t = std::max(tolerance, std::numeric_limits<double>::epsilon());
  return {std::min(no_digit, factor * t), std::min(no_digit, factor * factor * t),
          std::min(no_digit, factor * factor * factor * t)};
}

/// Returns whether a bound exceeds its limit, or is NaN, at any level.
inline bool exceeds(const PerLevel<double>& bound, const PerLevel<double>& limit) {
  return std::ranges::any_of(all_levels, [&](Level l) { return !(bound[l] <= limit[l]); });
}

/// Limits of the error bounds when positions are solved to a tolerance.
class Limits {
 public:
  explicit Limits(double tolerance)
      : degraded(powers(100, tolerance)), worth_correcting_(powers(10, tolerance)) {}

  /// Limits above which an instant that cannot be corrected further is degraded.
  const PerLevel<double> degraded;
  /// Returns the bounds above which an instant of that condition number is worth correcting. They
  /// are 10, 10² and 10³ times the tolerance, but at least ten times what conditioning allows
  /// (accuracy_limit()).
  PerLevel<double> worth_correcting(double condition) const {
    constexpr double over_floor = 10, unit_roundoff = 0x1p-53;
    PerLevel<double> least = accuracy_limit(condition, over_floor * unit_roundoff);
    for (const Level l : all_levels) least[l] = std::max(least[l], worth_correcting_[l]);
    return least;
  }

 private:
  PerLevel<double> worth_correcting_;
};

/// Converts bounds of rates from the scales `from` to the scales `to`, which have grown since.
inline void rescale(PerLevel<double>& bound, const Scales& from, const Scales& to) {
  for (const Level l : {Level::velocity, Level::acceleration}) {
    const auto share = [&](double before, double now) { return now > 0 ? before / now : 1; };
    bound[l] *=
        std::max(share(from.length[l], to.length[l]), share(from.rotation[l], to.rotation[l]));
  }
}

}  // namespace desmo
