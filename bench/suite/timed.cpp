#include "bench/suite/timed.h"

#include "bench/suite/fresh_heap.h"

namespace desmo::suite {

double Timed::time_afresh() {
  double seconds = 0;
  on_fresh_heap([&] {
    make();
    const double before = now(clock);
    analyse();
    seconds = now(clock) - before;
    discard();
  });
  return seconds;
}

void Timed::wake_threads(const std::function<void()>& solve) const {
  constexpr double enough = 0.03;  // s
  const double begin = now(clock);
  while (threads > 1 && now(clock) - begin < enough) solve();
}

}  // namespace desmo::suite
