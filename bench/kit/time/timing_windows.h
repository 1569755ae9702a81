#pragma once

#include <cstddef>
#include <vector>

#include "bench/kit/delivery.h"
#include "bench/kit/time/clock.h"

namespace desmo::bench {

/// Largest number of windows of a motion, and smallest number of instants of a window. Motions of
/// fewer than 2 · min_instants have two windows that are shorter; one instant has one. So reading
/// the clock costs little compared with solving, very short motions excepted.
inline constexpr int max_windows = 25, min_instants = 20;

/// Time and updates (Summary::updates) of each window of a motion, analysis by analysis. The time
/// of reading the clock is left out; assembly belongs to the first window. Other work of the
/// machine slows some windows of some analyses. The least time of each window over all analyses is
/// the undisturbed one.
class TimingWindows {
 public:
  explicit TimingWindows(int instants, Clock clock = Clock::cpu);

  /// Begins an analysis. Drops the windows of an earlier one that did not finish.
  void begin();
  /// Tells that all instants of the analysis so far are void. Their time becomes part of the first
  /// window.
  void restart();
  /// Tells that an instant was delivered. Every instant of the motion comes once, in any order.
  /// updates: those of the instant. By the wall clock they are not counted: several threads deliver
  /// in another order every time, so that a window has no updates of its own.
  void count_instant(long updates = 0) {
    if (clock_ == Clock::cpu) sum_ += updates;
    if (counted_++ == last_instants_[next_]) end();
  }

  std::size_t count() const { return last_instants_.size() - 1; }  ///< number of windows
  /// Returns the seconds of each window, for every whole analysis.
  const std::vector<std::vector<double>>& samples() const { return samples_; }
  /// Returns the least seconds of each window; infinite before the first whole analysis.
  std::vector<double> least() const;
  /// Returns the updates of each window in the last analysis; zeros if uncounted.
  const std::vector<long>& updates() const { return updates_; }

 private:
  void end();

  const Clock clock_;
  std::vector<int> last_instants_;  // by window: value of counted_ at its last instant; then -1
  std::vector<std::vector<double>> samples_;
  std::vector<double> sample_;             // times of the analysis under way, by window [s]
  std::vector<long> updates_;              // updates in the last analysis, by window
  std::size_t next_ = 0;                   // index of the window under way
  int counted_ = 0;                        // instants delivered in the analysis under way
  long sum_ = 0;                           // updates so far in the window under way
  double began_ = 0, analysis_began_ = 0;  // clock [s] when window and analysis under way began
};

/// A delivery that counts each instant in timing windows.
class WindowedDelivery final : public Delivery {
 public:
  WindowedDelivery(std::size_t coordinates, Level level, TimingWindows& windows)
      : Delivery(coordinates, level), windows_(windows) {}

  Flow observe(const Instant& instant) noexcept override {
    windows_.count_instant(instant.updates);
    return Delivery::observe(instant);
  }
  void restart() noexcept override { windows_.restart(); }

 private:
  TimingWindows& windows_;
};

}  // namespace desmo::bench
