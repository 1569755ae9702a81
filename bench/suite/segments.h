#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "bench/suite/cpu_clock.h"
#include "formulations/formulation.h"

namespace desmo::suite {

/// Into so many equal segments a motion is cut, or fewer, but two, where they would have fewer
/// instants than that: reading the clock is to cost little beside solving them.
inline constexpr int most_segments = 25, least_instants = 20;

/// The least CPU time that any analysis of a motion took for each of its segments, without that of
/// reading the clock; assembly belongs to the first. What else the machine does spoils some
/// segments of one analysis, and seldom the same in all of them: the sum of the least times is that
/// of an analysis which nothing disturbed.
class Segments {
 public:
  explicit Segments(int instants);

  /// An analysis begins.
  void begin() {
    next_ = 0;
    began_ = cpu_now();
  }
  /// An instant has been delivered. Every one of the motion is told, in order.
  void passed(int instant) {
    if (instant == last_instants_[next_]) end();
  }

  /// CPU seconds, in the order of the motion; infinite before the first whole analysis.
  const std::vector<double>& least() const { return least_; }

 private:
  void end();

  std::vector<int> last_instants_;  // of each segment, and one that never comes
  std::vector<double> least_;
  std::size_t next_ = 0;  // to end
  double began_ = 0;
};

/// Delivers as `Inner` does and tells the segments.
template <class Inner>
class SegmentedDelivery final : public Sink {
 public:
  SegmentedDelivery(Inner inner, Segments& segments)
      : inner_(std::move(inner)), segments_(segments) {}

  void accept(const Instant& instant) override {
    inner_.accept(instant);
    segments_.passed(instant.index);
  }

 private:
  Inner inner_;
  Segments& segments_;
};

}  // namespace desmo::suite
