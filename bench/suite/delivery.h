#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "formulations/formulation.h"

namespace desmo::suite {

/// Delivers each instant as the design asks: q, q̇, q̈ of the whole mechanism into plain vectors
/// in coordinate order.
class Delivery final : public Sink {
 public:
  explicit Delivery(int coordinates) : q_(coordinates), qd_(coordinates), qdd_(coordinates) {}

  void accept(const Instant& instant) override {
    std::ranges::copy(instant.q, q_.begin());
    std::ranges::copy(instant.qd, qd_.begin());
    std::ranges::copy(instant.qdd, qdd_.begin());
  }
  std::optional<Room> room(int) override { return Room{{}, q_.data(), qd_.data(), qdd_.data()}; }
  bool takes_any_order() const override { return true; }

 private:
  std::vector<double> q_, qd_, qdd_;
};

}  // namespace desmo::suite
