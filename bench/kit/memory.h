#pragma once

#include <malloc.h>

#include <cstddef>
#include <functional>

namespace desmo::bench {

/// Runs `work` to its end on a thread of its own, which has a heap of its own. On a heap with freed
/// memory of earlier work, data lie scattered: an analysis may take a quarter longer, in one run
/// and not in the next. The place of the data changes times by some percent, and is drawn at random
/// in each call. Throws what `work` throws.
void run_on_fresh_heap(const std::function<void()>& work);

/// Keeps freed memory in the process. Otherwise large blocks that UMFPACK frees after each
/// factorisation may go back to the system, depending on what ran before. Page faults are then
/// timed when they are needed again.
void keep_freed_memory();

/// Returns the bytes that are allocated on the heap at this moment. Unlike the size of the process
/// they do not depend on freed memory that the allocator keeps.
inline std::size_t heap_in_use() {
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

}  // namespace desmo::bench
