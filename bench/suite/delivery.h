#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "formulations/formulation.h"

namespace desmo::suite {

/// Delivers each instant as the design asks: q, q̇, q̈ of the whole mechanism into plain vectors
/// in coordinate order.
class Delivery final : public Sink {
 public:
  explicit Delivery(int coordinates)
      : rooms_({{}, Level::acceleration}, static_cast<std::size_t>(coordinates)) {}

  void accept(const Instant& instant) override {
    if (!instant.in_room) {
      const Room to = rooms_.take();
      std::ranges::copy(instant.q, to.q);
      std::ranges::copy(instant.qd, to.qd);
      std::ranges::copy(instant.qdd, to.qdd);
    }
    last_ = rooms_.give_back();
  }
  std::optional<RoomShape> rooms() const override { return rooms_.shape(); }
  Room room(int) override { return rooms_.take(); }
  bool takes_any_order() const override { return true; }

  /// What came last.
  std::span<const double> q() const { return {last_.q, rooms_.size()}; }
  std::span<const double> qd() const { return {last_.qd, rooms_.size()}; }
  std::span<const double> qdd() const { return {last_.qdd, rooms_.size()}; }

 private:
  RoomRing rooms_;
  Room last_{};
};

}  // namespace desmo::suite
