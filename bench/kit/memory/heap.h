#pragma once

#include <malloc.h>

#include <cstddef>

namespace desmo::bench {

/// Bytes of the heap that the process holds at this moment. Unlike the size of the process it does
/// not depend on what the allocator keeps.
inline std::size_t heap_in_use() { return mallinfo2().uordblks; }

}  // namespace desmo::bench
