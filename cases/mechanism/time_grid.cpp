// Compiled without fused operations: each operation of an instant is rounded (TimeGrid::time()).
#include <cmath>
#include <stdexcept>

#include "cases/mechanism/motion.h"

namespace desmo {

TimeGrid time_grid(double seconds, double step) {
  const double intervals = std::round(seconds / step);
  if (!(seconds > 0) || !(step > 0) || !std::isfinite(seconds) || !(intervals >= 1) ||
      !(intervals <= 1e9 - 1))
    throw std::invalid_argument(
        "time grid: duration and step must be positive, with 2 to 1e9 instants");
  return {0, step, static_cast<int>(intervals) + 1};
}

double TimeGrid::time(int i) const { return start + i * steps_per_interval * step; }

}  // namespace desmo
