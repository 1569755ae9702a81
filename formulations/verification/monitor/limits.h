#pragma once

#include <algorithm>
#include <limits>

#include "formulations/base/per_level.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/condition.h"

namespace desmo {

/// What a tolerance of position asks for at each level, the next being worse by what a moderate
/// condition number makes of it.
inline PerLevel<double> powers(double factor, double tolerance) {
  const double t = std::max(tolerance, std::numeric_limits<double>::epsilon());
  return {factor * t, factor * factor * t, factor * factor * factor * t};
}

/// Whether a bound is above its limit at any level.
inline bool exceeds(const PerLevel<double>& bound, const PerLevel<double>& limit) {
  return std::ranges::any_of(levels, [&](Level l) { return !(bound[l] <= limit[l]); });
}

/// Limits of the bounds of instants whose positions are solved to a tolerance.
class Limits {
 public:
  explicit Limits(double tolerance)
      : degraded(powers(100, tolerance)), worth_correcting_(powers(10, tolerance)) {}

  /// Above which an instant that cannot be corrected further is degraded.
  const PerLevel<double> degraded;
  /// The bounds above which an instant of that condition number is corrected: not below ten times
  /// what conditioning allows (accuracy_limit).
  PerLevel<double> worth_correcting(double condition) const {
    constexpr double over_floor = 10, unit_roundoff = 0x1p-53;
    PerLevel<double> least = accuracy_limit(condition, over_floor * unit_roundoff);
    for (const Level l : levels) least[l] = std::max(least[l], worth_correcting_[l]);
    return least;
  }

 private:
  PerLevel<double> worth_correcting_;
};

/// Bounds relative to scales that have grown since.
inline void rescale(PerLevel<double>& bound, const Scales& from, const Scales& to) {
  for (const Level l : {Level::velocity, Level::acceleration}) {
    const auto share = [&](double before, double now) { return now > 0 ? before / now : 1; };
    bound[l] *=
        std::max(share(from.length[l], to.length[l]), share(from.rotation[l], to.rotation[l]));
  }
}

}  // namespace desmo
