#pragma once

#include <ctime>

namespace desmo::bench {

/// CPU seconds of this thread.
inline double cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace desmo::bench
