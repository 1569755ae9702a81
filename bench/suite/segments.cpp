#include "bench/suite/segments.h"

#include <algorithm>
#include <limits>

namespace desmo::suite {

namespace {

/// The least CPU seconds between two readings of the clock: what every segment has of it.
double clock_seconds() {
  double least = 1;
  for (int i = 0; i < 1000; ++i) {
    const double before = cpu_now();
    least = std::min(least, cpu_now() - before);
  }
  return least;
}

}  // namespace

Segments::Segments(int instants) {
  const int count = std::min(instants, std::clamp(instants / least_instants, 2, most_segments));
  for (int i = 1; i <= count; ++i)
    last_instants_.push_back(static_cast<int>(static_cast<long>(i) * instants / count) - 1);
  last_instants_.push_back(-1);
  least_.assign(count, std::numeric_limits<double>::infinity());
}

void Segments::end() {
  static const double clock = clock_seconds();
  constexpr double resolution = 1e-9;
  const double now = cpu_now();
  least_[next_] = std::min(least_[next_], std::max(resolution, now - began_ - clock));
  began_ = now;
  ++next_;
}

}  // namespace desmo::suite
