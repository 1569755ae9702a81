#pragma once

#include <string_view>
#include <vector>

#include "report/statistics/windows.h"

namespace desmo::report {

/// The clock of a time. Times of two clocks share neither a column nor a ratio.
enum class Clock {
  cpu,   ///< CPU seconds of one thread
  wall,  ///< seconds that passed: where several threads work, and for what is compared with them
};

/// Samples of a time, by one clock.
struct Time {
  Clock clock = Clock::cpu;
  std::vector<double> seconds;  ///< one per repetition
  Windows windows;              ///< as many as the record's settings say; one by the wall clock
};

/// Tells whether a formulation of this id, with settings, is measured by the wall clock.
inline bool is_by_wall(std::string_view id) {
  return id.find("/threads:") != id.npos || id.find("/clock:wall") != id.npos;
}

}  // namespace desmo::report
