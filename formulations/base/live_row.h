#pragma once

#include <span>

namespace desmo {

/// Driver values that the caller of a step hands in, in the order of Model::drivers. Each span has
/// Model::degrees_of_freedom() values. Spans above the level that is solved may be empty. The
/// values must stay valid until the call returns.
struct LiveRow {
  double time;                    ///< time of the step [s]
  std::span<const double> z{};    ///< positions z [unit of length] or [rad]
  std::span<const double> zd{};   ///< velocities ż [unit of z/s]
  std::span<const double> zdd{};  ///< accelerations z̈ [unit of z/s²]
};

}  // namespace desmo
