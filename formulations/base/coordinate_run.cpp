#include "formulations/base/coordinate_run.h"

namespace desmo {

std::vector<CoordinateRun> runs_of(std::span<const int> coordinates) {
  std::vector<CoordinateRun> runs;
  for (const int i : coordinates) {
    if (runs.empty() || runs.back().end != i) runs.push_back({i, i});
    ++runs.back().end;
  }
  return runs;
}

}  // namespace desmo
