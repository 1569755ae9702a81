#pragma once

#include <chrono>

#include "bench/kit/time/cpu_clock.h"

namespace desmo::bench {

/// What tells how long an analysis takes.
enum class Clock {
  cpu,   ///< CPU seconds of this thread: what else the machine does is not in them
  wall,  ///< seconds: for work that several threads share
};

inline double now(Clock clock) {
  if (clock == Clock::cpu) return cpu_now();
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace desmo::bench
