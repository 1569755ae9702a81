#pragma once

#include <span>

namespace desmo {

/// Where the values of an instant are wanted: those of some requested coordinates, one behind the
/// other. Null: not wanted.
struct Room {
  std::span<const int> coordinates;  ///< each once; none standing for all, in their order
  double *q, *qd, *qdd;
};

}  // namespace desmo
