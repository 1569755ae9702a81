#include "bench/kit/time/timing_windows.h"

#include <algorithm>
#include <limits>

namespace desmo::bench {

namespace {

/// Returns the least time [s] between two readings of a clock, which every window includes.
double reading_seconds(Clock clock) {
  double least = 1;
  for (int i = 0; i < 1000; ++i) {
    const double before = now(clock);
    least = std::min(least, now(clock) - before);
  }
  return least;
}

}  // namespace

TimingWindows::TimingWindows(int instants, Clock clock) : clock_(clock) {
  const int count = std::min(instants, std::clamp(instants / min_instants, 2, max_windows));
  for (int i = 1; i <= count; ++i)
    last_instants_.push_back(static_cast<int>(static_cast<long>(i) * instants / count) - 1);
  last_instants_.push_back(-1);
  sample_.resize(count);
  updates_.resize(count);
}

void TimingWindows::begin() {
  samples_.reserve(samples_.size() + 1);
  analysis_began_ = now(clock_);
  restart();
}

void TimingWindows::restart() {
  next_ = 0;
  counted_ = 0;
  sum_ = 0;
  began_ = analysis_began_;
}

std::vector<double> TimingWindows::least() const {
  std::vector<double> least(count(), std::numeric_limits<double>::infinity());
  for (const std::vector<double>& sample : samples_)
    for (std::size_t i = 0; i < least.size(); ++i) least[i] = std::min(least[i], sample[i]);
  return least;
}

void TimingWindows::end() {
  static const double reading[] = {reading_seconds(Clock::cpu), reading_seconds(Clock::wall)};
  constexpr double resolution = 1e-9;  // least time of a window [s], for a positive result
  const double ended = now(clock_);
  sample_[next_] = std::max(resolution, ended - began_ - reading[static_cast<std::size_t>(clock_)]);
  updates_[next_] = sum_;
  sum_ = 0;
  if (++next_ == count()) samples_.push_back(sample_);
  began_ = now(clock_);
}

}  // namespace desmo::bench
