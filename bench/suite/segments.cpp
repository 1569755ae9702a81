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
  sample_.resize(count);
  updates_.resize(count);
}

void Segments::begin() {
  next_ = 0;
  passed_ = 0;
  sum_ = 0;
  samples_.reserve(samples_.size() + 1);
  began_ = cpu_now();
}

std::vector<double> Segments::least() const {
  std::vector<double> least(count(), std::numeric_limits<double>::infinity());
  for (const std::vector<double>& sample : samples_)
    for (std::size_t i = 0; i < least.size(); ++i) least[i] = std::min(least[i], sample[i]);
  return least;
}

void Segments::end() {
  static const double clock = clock_seconds();
  constexpr double resolution = 1e-9;
  const double now = cpu_now();
  sample_[next_] = std::max(resolution, now - began_ - clock);
  updates_[next_] = sum_;
  sum_ = 0;
  if (++next_ == count()) samples_.push_back(sample_);
  began_ = cpu_now();
}

}  // namespace desmo::suite
