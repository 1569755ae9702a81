#pragma once

#include <functional>

namespace desmo::bench {

/// Runs `work` to its end on a thread of its own, which has a heap of its own: among what others
/// have left on a used one, data lie so scattered that an analysis takes up to a quarter longer, in
/// one run and not in the next. On which pages they lie, and where in them, is luck, worth some
/// percent, and drawn anew each time. Throws what `work` throws.
void on_fresh_heap(const std::function<void()>& work);

}  // namespace desmo::bench
