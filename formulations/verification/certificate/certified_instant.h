#pragma once

#include <span>
#include <vector>

#include "formulations/base/per_level.h"

namespace desmo {

/// Returns the levels at which there are values, from positions up.
inline std::span<const Level> levels_of(const PerLevel<std::span<const double>>& values) {
  return std::span(all_levels)
      .first(values.velocity.empty()       ? 1
             : values.acceleration.empty() ? 2
                                           : 3);
}

/// An instant whose positions are certified.
struct CertifiedInstant {
  double time = 0;                             ///< [s]
  PerLevel<std::span<const double>> values{};  ///< all coordinates; empty above the levels it has
  std::span<const double> radius{};            ///< bounds on the errors of the positions
  /// Level up to which each coordinate is solved; empty: the highest level of `values`.
  std::span<const Level> levels{};
};

/// A copy of a certified instant, in memory of its own.
struct InstantCopy {
  double time = 0;                         ///< [s]
  PerLevel<std::vector<double>> values{};  ///< (coordinates), or empty
  std::vector<double> radius{};            ///< see CertifiedInstant (coordinates), or empty

  InstantCopy() = default;
  /// Allocates all levels.
  explicit InstantCopy(int coordinates) : radius(coordinates) {
    for (const Level level : all_levels) values[level].resize(coordinates);
  }

  /// Copies an instant without CertifiedInstant::levels. The instant must not be a view of this
  /// copy. Allocates nothing at levels that have memory already.
  void assign(const CertifiedInstant& instant) {
    time = instant.time;
    for (const Level level : all_levels)
      values[level].assign(instant.values[level].begin(), instant.values[level].end());
    radius.assign(instant.radius.begin(), instant.radius.end());
  }
  /// Returns the instant, which is valid until the copy changes. levels: as in CertifiedInstant.
  CertifiedInstant view(std::span<const Level> levels = {}) const {
    return {time, {values.position, values.velocity, values.acceleration}, radius, levels};
  }
};

}  // namespace desmo
