#pragma once

#include <malloc.h>

namespace desmo::bench {

/// Freed memory stays with the process. Otherwise what UMFPACK frees after each factorisation goes
/// back to the system beyond some size, its page faults are timed, and whether that happens depends
/// on what ran before.
inline void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 1 << 28);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
}

}  // namespace desmo::bench
