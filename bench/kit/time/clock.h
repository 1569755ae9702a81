#pragma once

#include <chrono>
#include <ctime>

namespace desmo::bench {

/// Returns the CPU time of this thread [s].
inline double cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// A clock that tells how long an analysis takes.
enum class Clock {
  cpu,   ///< CPU time of this thread, without what else the machine does
  wall,  ///< for work that several threads share
};

/// Least time [s] for which runs are repeated where the wall clock measures. After this time all
/// threads are awake, and have run at the same time.
inline constexpr double min_wall_seconds = 0.03;

/// Returns the reading of a clock [s].
inline double now(Clock clock) {
  if (clock == Clock::cpu) return cpu_now();
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace desmo::bench
