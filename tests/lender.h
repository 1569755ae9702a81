#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "formulations/formulation.h"

namespace desmo {

/// An observer that lends memory for some coordinates of each instant of a motion, up to a level.
class Lender : public Observer {
 public:
  Lender(int instants, std::vector<int> coordinates, Level level, int at_once = 1)
      : coordinates_(std::move(coordinates)), level_(level), at_once_(at_once), values_(instants) {}

  Flow observe(const Instant& instant) noexcept override {
    ++instants;
    updates += instant.updates;
    threads.insert(std::this_thread::get_id());
    const double* const lent = values_.at(instant.index).data();
    EXPECT_EQ(instant.q.data(), lent);
    EXPECT_EQ(instant.output.q, lent);
    EXPECT_EQ(instant.q.size(), coordinates_.size());
    EXPECT_EQ(instant.qd.size(), level_ >= Level::velocity ? coordinates_.size() : 0);
    return instant.index == stop_at ? Flow::stop : Flow::go_on;
  }
  int lent_at_once() const noexcept override { return at_once_; }
  void lend(std::span<const int> instants, std::span<OutputView> outputs) noexcept override {
    ++asked;
    for (std::size_t i = 0; i < outputs.size(); ++i) outputs[i] = output(instants[i]);
  }
  bool any_order() const noexcept override { return true; }
  void restart() noexcept override { ++restarts; }

  /// Returns the memory lent for an instant: positions, velocities, accelerations; `untouched`
  /// where nothing was written.
  const std::vector<double>& values(int instant) const { return values_.at(instant); }

  static constexpr double untouched = -77;
  int stop_at = -1;
  int instants = 0, asked = 0, restarts = 0;
  long updates = 0;                   // sum over the instants
  std::set<std::thread::id> threads;  // threads that delivered instants

 private:
  OutputView output(int instant) {
    const std::size_t size = coordinates_.size();
    std::vector<double>& values = values_.at(instant);
    values.assign(3 * size, untouched);
    const auto up_to = [&](Level level, std::size_t first) {
      return level <= level_ ? values.data() + first : nullptr;
    };
    return {values.data(), up_to(Level::velocity, size), up_to(Level::acceleration, 2 * size)};
  }

  std::vector<int> coordinates_;
  Level level_;
  int at_once_;
  std::vector<std::vector<double>> values_;
};

/// Expects lent memory to hold these coordinates of Everything::all up to the level, no more.
inline void expect_in_outputs(const Lender& lender, const std::vector<int>& coordinates,
                              Level level, const std::vector<std::vector<double>>& everything) {
  for (std::size_t i = 0; i < everything.size(); ++i)
    for (std::size_t order = 0; order < 3; ++order)
      for (std::size_t n = 0; n < coordinates.size(); ++n) {
        const double there = lender.values(static_cast<int>(i))[order * coordinates.size() + n];
        const double expected = everything[i][order * (everything[i].size() / 3) + coordinates[n]];
        EXPECT_EQ(there, order <= static_cast<std::size_t>(level) ? expected : Lender::untouched)
            << i << " " << n;
      }
}

}  // namespace desmo
