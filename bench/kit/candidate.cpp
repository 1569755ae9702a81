#include "bench/kit/candidate.h"

#include <algorithm>
#include <limits>

#include "bench/kit/memory/fresh_heap.h"

namespace desmo::bench {

namespace {

/// By the wall clock, s: for threads to be awake in the end, and to have all had a processor at the
/// same time.
constexpr double long_enough = 0.03;

}  // namespace

double Candidate::time_afresh() {
  double least = std::numeric_limits<double>::infinity();
  on_fresh_heap([&] {
    make();
    const double begin = now(clock);
    do {
      const double before = now(clock);
      analyse();
      least = std::min(least, now(clock) - before);
    } while (clock == Clock::wall && !is_failed() && now(clock) - begin < long_enough);
    discard();
  });
  return least;
}

void Candidate::wake_threads(const std::function<void()>& solve) const {
  const double begin = now(clock);
  while (clock == Clock::wall && now(clock) - begin < long_enough) solve();
}

}  // namespace desmo::bench
