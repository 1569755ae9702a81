#pragma once

#include <span>

namespace desmo {

/// Driver values that are handed in at one step, in the order of Model::drivers. The spans have
/// Model::degrees_of_freedom() values; those beyond the level that is solved may be empty.
struct LiveRow {
  double time;  ///< s
  std::span<const double> z{}, zd{}, zdd{};
};

}  // namespace desmo
