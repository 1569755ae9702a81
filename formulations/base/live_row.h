#pragma once

#include <span>

namespace desmo {

/// Driver values that are handed in at one step, in the order of Model::drivers. The spans have
/// Model::degrees_of_freedom() values; those beyond the level that is solved may be empty. They are
/// read until the call returns.
struct LiveRow {
  double time;                    ///< time of the step [s]
  std::span<const double> z{};    ///< positions z [unit of length] or [rad]
  std::span<const double> zd{};   ///< velocities ż [unit of z/s]
  std::span<const double> zdd{};  ///< accelerations z̈ [unit of z/s²]
};

}  // namespace desmo
