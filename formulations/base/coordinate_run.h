#pragma once

#include <span>
#include <vector>

namespace desmo {

/// Coordinates that stand together: what is done to all is done without looking any up.
struct CoordinateRun {
  int first, end;
};

/// Ascending coordinates as runs.
std::vector<CoordinateRun> runs_of(std::span<const int> coordinates);

}  // namespace desmo
