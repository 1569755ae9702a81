#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "formulations/formulation.h"

namespace desmo {

/// Room for some coordinates of each instant of a motion, up to a level.
class Rooms : public Sink {
 public:
  Rooms(int instants, std::vector<int> coordinates, Level level)
      : coordinates_(std::move(coordinates)), level_(level), values_(instants) {}

  void accept(const Instant& instant) override { handed_over += !instant.in_room; }
  std::optional<RoomShape> rooms() const override { return RoomShape{coordinates_, level_}; }
  Room room(int instant) override {
    const std::size_t size = coordinates_.size();
    std::vector<double>& values = values_.at(instant);
    values.assign(3 * size, untouched);
    const auto up_to = [&](Level level, std::size_t first) {
      return level <= level_ ? values.data() + first : nullptr;
    };
    return {values.data(), up_to(Level::velocity, size), up_to(Level::acceleration, 2 * size)};
  }
  bool takes_any_order() const override { return true; }

  /// Of an instant: the positions, then what is left of rates.
  const std::vector<double>& values(int instant) const { return values_.at(instant); }

  static constexpr double untouched = -77;
  int handed_over = 0;  // instants that came otherwise

 private:
  std::vector<int> coordinates_;
  Level level_;
  std::vector<std::vector<double>> values_;
};

/// That rooms hold of some coordinates what is in everything (see Everything), and no more.
inline void expect_in_rooms(const Rooms& rooms, const std::vector<int>& coordinates, Level level,
                            const std::vector<std::vector<double>>& everything) {
  EXPECT_EQ(rooms.handed_over, 0);
  for (std::size_t i = 0; i < everything.size(); ++i)
    for (std::size_t order = 0; order < 3; ++order)
      for (std::size_t n = 0; n < coordinates.size(); ++n) {
        const double there = rooms.values(static_cast<int>(i))[order * coordinates.size() + n];
        const double expected = everything[i][order * (everything[i].size() / 3) + coordinates[n]];
        EXPECT_EQ(there, order <= static_cast<std::size_t>(level) ? expected : Rooms::untouched)
            << i << " " << n;
      }
}

}  // namespace desmo
