#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "formulations/base/observer.h"

namespace desmo {

/// Keeps the instants of a motion, in whatever order and from whatever thread they come.
class Trajectory final : public Observer {
 public:
  /// coordinates: of each instant, all of which are requested up to `level`.
  Trajectory(int instants, int coordinates, Level level);

  Flow observe(const Instant& instant) noexcept override;
  int lent_at_once() const noexcept override { return static_cast<int>(instants_.size()); }
  void lend(std::span<const int> instants, std::span<OutputView> outputs) noexcept override;
  bool any_order() const noexcept override { return true; }
  Observer* of_thread(int) noexcept override { return this; }

  /// Returns the instants in order of time.
  std::span<const Instant> instants() const { return instants_; }

 private:
  std::size_t coordinates_;
  std::vector<Instant> instants_;
  std::vector<double> q_, qd_, qdd_;  // of all instants; empty above the level
};

}  // namespace desmo
