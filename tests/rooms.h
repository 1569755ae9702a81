#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "formulations/formulation.h"

namespace desmo {

/// Room for some coordinates of each instant of a motion, up to a level.
class Rooms : public Observer {
 public:
  Rooms(int instants, std::vector<int> coordinates, Level level, int at_once = 1)
      : coordinates_(std::move(coordinates)), level_(level), at_once_(at_once), values_(instants) {}

  void observe(const Instant& instant) override { handed_over += !instant.in_room(); }
  std::optional<RoomShape> rooms() const override {
    return RoomShape{coordinates_, level_, at_once_};
  }
  void take_rooms(std::span<const int> instants, std::span<Room> rooms) override {
    ++asked;
    for (std::size_t i = 0; i < rooms.size(); ++i) rooms[i] = room(instants[i]);
  }
  bool takes_any_order() const override { return true; }

  /// Of an instant: the positions, then what is left of rates.
  const std::vector<double>& values(int instant) const { return values_.at(instant); }

  static constexpr double untouched = -77;
  int handed_over = 0;  // instants that came otherwise
  int asked = 0;        // how often for rooms

 private:
  Room room(int instant) {
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

/// Coordinates of which no mechanism with so many can fill a room.
inline std::vector<std::vector<int>> without_room(int coordinates) {
  return {{7, 8, 7}, {coordinates}, {3, -1}};
}

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
