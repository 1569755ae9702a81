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

}  // namespace desmo::suite
