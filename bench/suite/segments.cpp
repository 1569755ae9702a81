#include "bench/suite/segments.h"

#include <algorithm>
#include <limits>

namespace desmo::suite {

Segments::Segments(int instants) {
  const int count = std::min(instants, std::clamp(instants / least_instants, 2, most_segments));
  for (int i = 1; i <= count; ++i)
    last_instants_.push_back(static_cast<int>(static_cast<long>(i) * instants / count) - 1);
  last_instants_.push_back(-1);
  least_.assign(count, std::numeric_limits<double>::infinity());
}

void Segments::end() {
  const double now = cpu_now();
  least_[next_] = std::min(least_[next_], now - began_);
  began_ = now;
  ++next_;
}

}  // namespace desmo::suite
