#pragma once

namespace desmo::allocation_test {

/// Counts allocations of the whole program from now on. malloc() and its relatives are interposed;
/// while counting goes on, every thread's calls count.
void begin_counting();

/// Ends the count and returns it.
long end_counting();

/// Returns the number of allocations that some work makes.
long count(const auto& work) {
  begin_counting();
  work();
  return end_counting();
}

}  // namespace desmo::allocation_test
