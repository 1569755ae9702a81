#pragma once

#include <span>

namespace desmo {

/// Driver values that are handed in at one step, in the order of Model::drivers. The spans have
/// Model::degrees_of_freedom() values; those beyond the level that is solved may be empty. They are
/// read until the call returns.
struct LiveRow {
  double time;                    ///< [s]
  std::span<const double> z{};    ///< [unit of length] or [rad]
  std::span<const double> zd{};   ///< ż [that/s]
  std::span<const double> zdd{};  ///< z̈ [that/s²]
};

}  // namespace desmo
