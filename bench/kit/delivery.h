#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "formulations/formulation.h"

namespace desmo::bench {

/// Delivers each instant as the design asks: q, q̇, q̈ of the whole mechanism into plain vectors
/// in coordinate order.
class Delivery final : public Observer {
 public:
  explicit Delivery(int coordinates)
      : rooms_({{}, Level::acceleration}, static_cast<std::size_t>(coordinates)) {}

  void observe(const Instant& instant) override {
    last_ = instant.room;
    if (!instant.in_room()) {
      last_ = rooms_.take();
      std::ranges::copy(instant.q, last_.q);
      std::ranges::copy(instant.qd, last_.qd);
      std::ranges::copy(instant.qdd, last_.qdd);
    }
    rooms_.give_back(last_);
  }
  std::optional<RoomShape> rooms() const override { return rooms_.shape(); }
  void take_rooms(std::span<const int>, std::span<Room> rooms) override {
    for (Room& room : rooms) room = rooms_.take();
  }
  bool takes_any_order() const override { return true; }

  /// What came last.
  std::span<const double> q() const { return {last_.q, rooms_.size()}; }
  std::span<const double> qd() const { return {last_.qd, rooms_.size()}; }
  std::span<const double> qdd() const { return {last_.qdd, rooms_.size()}; }

 private:
  RoomPool rooms_;
  Room last_{};
};

}  // namespace desmo::bench
