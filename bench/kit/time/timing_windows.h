#pragma once

#include <cstddef>
#include <vector>

#include "bench/kit/delivery.h"
#include "bench/kit/time/clock.h"

namespace desmo::bench {

/// Number of equal windows of a motion, and instants that each has at least where two can have as
/// many: reading the clock is to cost little compared with solving them.
inline constexpr int max_windows = 25, min_instants = 20;

/// The time that analyses of a motion took for each of its windows, without that of reading
/// the clock, and the work that was done in it; assembly belongs to the first. What else the
/// machine does slows some windows of some analyses: what the same work takes undisturbed shows in
/// the others.
class TimingWindows {
 public:
  explicit TimingWindows(int instants, Clock clock = Clock::cpu);

  /// An analysis begins. What one that did not come to its end has left is dropped.
  void begin();
  /// Says that all instants so far are void: their time is part of the first window.
  void restart();
  /// An instant has been delivered: every one of the motion, in whatever order, with the updates
  /// that it took (see Summary) where somebody counts. From several threads they come in another
  /// order every time, so that their work is not that of a window: it is not counted.
  void passed(long updates = 0) {
    if (clock_ == Clock::cpu) sum_ += updates;
    if (passed_++ == last_instants_[next_]) end();
  }

  std::size_t count() const { return last_instants_.size() - 1; }
  /// Seconds of every whole analysis, in the order of the motion.
  const std::vector<std::vector<double>>& samples() const { return samples_; }
  /// Their least; infinite before the first whole analysis.
  std::vector<double> least() const;
  /// Returns the updates of the last analysis, in the order of the motion; zeros if uncounted.
  const std::vector<long>& updates() const { return updates_; }

 private:
  void end();

  const Clock clock_;
  std::vector<int> last_instants_;  // of each window, and one that never comes
  std::vector<std::vector<double>> samples_;
  std::vector<double> sample_;  // of the analysis that goes on
  std::vector<long> updates_;
  std::size_t next_ = 0;  // to end
  int passed_ = 0;        // instants
  long sum_ = 0;          // of updates in the window that goes on
  double began_ = 0, analysis_began_ = 0;
};

/// Delivers and tells the windows.
class WindowedDelivery final : public Delivery {
 public:
  WindowedDelivery(std::size_t coordinates, Level level, TimingWindows& windows)
      : Delivery(coordinates, level), windows_(windows) {}

  Flow observe(const Instant& instant) noexcept override {
    windows_.passed(instant.updates);
    return Delivery::observe(instant);
  }
  void restart() noexcept override { windows_.restart(); }

 private:
  TimingWindows& windows_;
};

}  // namespace desmo::bench
