#pragma once

#include <span>

#include "formulations/base/output_writer.h"
#include "formulations/formulation.h"

namespace desmo::bench {

/// Returns q, q̇ or q̈ of a state, an instant, a reference or an answer.
const auto& values_at(const auto& solved, Level level) {
  return level == Level::position ? solved.q : level == Level::velocity ? solved.qd : solved.qdd;
}

/// Observer that takes q, q̇ and q̈ of the requested coordinates, by default of all, into plain
/// vectors in the order of the request.
class Delivery : public Observer {
 public:
  /// coordinates, level: number of coordinates and level of the request.
  explicit Delivery(std::size_t coordinates, Level level = Level::acceleration)
      : outputs_(coordinates, level) {}

  Flow observe(const Instant& instant) noexcept override {
    last_ = instant.output;
    outputs_.give_back(last_);
    return Flow::go_on;
  }
  int lent_at_once() const noexcept override { return 1; }
  void lend(std::span<const int>, std::span<OutputView> outputs) noexcept override {
    for (OutputView& output : outputs) output = outputs_.take();
  }
  bool any_order() const noexcept override { return true; }

  /// Returns q of the instant observed last; empty before any.
  std::span<const double> q() const { return {last_.q, last_.q ? outputs_.size() : 0}; }

 private:
  OutputPool outputs_;
  OutputView last_{};
};

}  // namespace desmo::bench
