#include "formulations/verification/monitor/condition_monitor.h"

#include <algorithm>
#include <cmath>

namespace desmo {

namespace {

/// Groups that the right-hand side hardly moves count as this part of the one that it moves most.
constexpr double min_part = 0.5;
/// From one look to the next: by what part a share may change, and how far drivers may go, in their
/// magnitudes and beside the way to the look before.
constexpr double allowed = 0.5, longest = 2, growth_factor = 4;
/// Of the fastest change so far, what still counts at the next look: it may only have paused.
constexpr double remembered = 0.5;

}  // namespace

ConditionMonitor::ConditionMonitor(const Model& m, const ScaledSystem& system)
    : state_(m.state_size()),
      right_(system.size()),
      x_(system.size()),
      now_(Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(m.groups.size()))),
      then_(now_),
      share_(now_) {
  std::ranges::copy(m.fixed_values, state_.begin() + m.coordinates());
  for (const Driver& d : m.drivers) {
    const int i = m.entities[d.coordinate].first;
    drivers_.push_back({i, 1 / system.magnitude(i)});
  }
  const std::vector<EntityId> entity = entity_of_coordinate(m);
  unsigned bits = 0;  // of no pattern, so that next to nothing is at right angles to it
  for (int j = 0; j < system.size(); ++j) {
    group_.push_back(m.entities[entity[system.unknowns()[j]]].group);
    bits += 2654435769u;
    const double size = 0.5 + (bits & 0x7fffffffu) * 0x1p-32;
    right_[j] = bits >> 31 ? -size : size;
  }
}

void ConditionMonitor::go_on(const Instant& instant) {
  double step = 0;
  for (Driven& d : drivers_) {
    const double position = instant.q[d.coordinate];
    step = std::max(step, std::abs(position - d.last) * d.unit);
    d.last = position;
  }
  way_ += step;
}

void ConditionMonitor::look(const Instant& instant, ScaledSystem& system) {
  std::ranges::copy(instant.q, state_.begin());
  if (system.factor(state_)) return take(system);
  growth_ = INFINITY;
  fall_ = way_ = next_ = 0;
}

void ConditionMonitor::reset(ScaledSystem& system) {
  take(system);
  then_ = now_;
  share_.setOnes();
  growth_ = 1;
}

void ConditionMonitor::take(ScaledSystem& system) {
  if (system.size() == 0) return;
  x_ = right_;
  system.solve(x_.data());
  now_.setZero();
  for (int j = 0; j < system.size(); ++j)
    now_[group_[j]] = std::max(now_[group_[j]], std::abs(x_[j]));
  now_ = now_.max(min_part * x_.abs().maxCoeff());
  growth_ = 1;
  double fall = 0, change = 0;
  for (Eigen::Index g = 0; g < now_.size(); ++g) {
    const double share = then_[g] / now_[g];
    growth_ = std::max(growth_, 1 / share);
    const double before = share_[g] / share;
    fall = std::max(fall, before - 1);
    change = std::max({change, before - 1, 1 / before - 1});
    share_[g] = share;
  }
  if (way_ > 0) {
    fall_ = fall / way_;
    pace_ = std::max(change / way_, remembered * pace_);
    next_ = std::min({longest, growth_factor * way_, allowed / pace_});
  }
  way_ = 0;
}

}  // namespace desmo
