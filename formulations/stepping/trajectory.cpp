#include "formulations/stepping/trajectory.h"

namespace desmo {

Trajectory::Trajectory(int instants, int coordinates, Level level)
    : coordinates_(static_cast<std::size_t>(coordinates)),
      instants_(instants),
      q_(instants_.size() * coordinates_),
      qd_(level >= Level::velocity ? q_.size() : 0),
      qdd_(level >= Level::acceleration ? q_.size() : 0) {}

Flow Trajectory::observe(const Instant& instant) noexcept {
  instants_[instant.index] = instant;
  return Flow::go_on;
}

void Trajectory::lend(std::span<const int> instants, std::span<OutputView> outputs) noexcept {
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const auto of_instant = [&](std::vector<double>& values) {
      return values.empty() ? nullptr : &values[instants[i] * coordinates_];
    };
    outputs[i] = {of_instant(q_), of_instant(qd_), of_instant(qdd_)};
  }
}

}  // namespace desmo
