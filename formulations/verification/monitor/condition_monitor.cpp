#include "formulations/verification/monitor/condition_monitor.h"

#include <algorithm>
#include <cmath>

namespace desmo {

namespace {

/// Groups that the right-hand side hardly moves count as this part of the one that it moves most.
constexpr double min_part = 0.5;
/// By what part a distance, or the share of a group, may fall from one look to the next.
constexpr double allowed = 0.5;
/// Largest slope and curvature of a distance, over the way in magnitudes.
constexpr double steepest = 2, curvature = 2;

Eigen::Map<const Eigen::ArrayXd> mapped(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

}  // namespace

ConditionMonitor::ConditionMonitor(const Model& m, const ScaledSystem& system)
    : state_(m.state_size()),
      unit_(mapped(system.magnitudes()).head(m.coordinates()).inverse()),
      last_(Eigen::ArrayXd::Constant(m.coordinates(), NAN)),
      right_{Eigen::ArrayXd(system.size()), Eigen::ArrayXd(system.size())},
      x_(system.size()),
      now_(Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(m.groups.size()))),
      then_(now_),
      before_(now_) {
  std::ranges::copy(m.fixed_values, state_.begin() + m.coordinates());
  const std::vector<EntityId> entity = entity_of_coordinate(m);
  unsigned bits = 0;  // of no pattern, so that next to nothing is at right angles to them
  for (int j = 0; j < system.size(); ++j) {
    group_.push_back(m.entities[entity[system.unknowns()[j]]].group);
    block_.push_back(system.block(j));
    for (Eigen::ArrayXd& right : right_) {
      bits += 2654435769u;
      const double size = 0.5 + (bits & 0x7fffffffu) * 0x1p-32;
      right[j] = bits >> 31 ? -size : size;
    }
  }
  const int blocks = system.size() > 0 ? std::ranges::max(block_) + 1 : 0;
  distance_ = distance_before_ = Eigen::ArrayXd::Zero(blocks);
}

void ConditionMonitor::go_on(const Instant& instant) {
  if (last_.size() == 0) return;
  const double step = ((mapped(instant.q) - last_).abs() * unit_).maxCoeff();
  if (step > 0) way_ += step;
  last_ = mapped(instant.q);
}

void ConditionMonitor::look(const Instant& instant, ScaledSystem& system) {
  std::ranges::copy(instant.q, state_.begin());
  if (system.factorise(state_)) {
    take(system);
    if (!std::ranges::equal(system.orientation(), signs_)) growth_ = INFINITY;
    return;
  }
  growth_ = INFINITY;
  distance_.setZero();
  way_before_ = way_;
  way_ = next_ = 0;
}

void ConditionMonitor::reset(ScaledSystem& system) {
  take(system);
  then_ = now_;
  signs_.assign(system.orientation().begin(), system.orientation().end());
  growth_ = 1;
}

double ConditionMonitor::growth() const {
  return next_ > 0 ? growth_ / (1 - allowed * std::min(1.0, way_ / next_)) : growth_;
}

void ConditionMonitor::take(ScaledSystem& system) {
  if (system.size() == 0) return;
  const bool has_moved = way_ > 0;
  if (has_moved) {
    way_before_ = way_;
    before_ = now_;
    distance_before_ = distance_;
  }
  way_ = 0;
  x_ = right_[0];
  system.solve(x_.data());
  now_.setZero();
  for (int j = 0; j < system.size(); ++j)
    now_[group_[j]] = std::max(now_[group_[j]], std::abs(x_[j]));
  now_ = now_.max(min_part * x_.abs().maxCoeff());
  growth_ = std::max(1.0, (now_ / then_).maxCoeff());
  measure_distances(system);
  next_ = until_halved();
}

void ConditionMonitor::measure_distances(ScaledSystem& system) {
  distance_.setZero();  // of 1/d, at first
  for (const Eigen::ArrayXd& right : right_) {
    x_ = right;
    system.solve_blocks(x_.data());
    for (int j = 0; j < system.size(); ++j)
      distance_[block_[j]] = std::max(distance_[block_[j]], std::abs(x_[j]));
  }
  distance_ = distance_.inverse();
}

/// Returns the way on which no block's distance can halve, and no group's share at its last pace.
double ConditionMonitor::until_halved() const {
  double way = INFINITY;
  for (Eigen::Index b = 0; b < distance_.size(); ++b) {
    double slope = steepest;  // of the fall, at most
    if (way_before_ > 0)
      slope = std::min(
          slope, (distance_before_[b] - distance_[b]) / way_before_ + curvature / 2 * way_before_);
    // slope w + curvature w² / 2 = allowed d
    const double root = std::sqrt(slope * slope + 2 * curvature * allowed * distance_[b]);
    way = std::min(way, (root - slope) / curvature);
  }
  if (way_before_ > 0 && before_.size() > 0) {
    const double pace = (now_ / before_ - 1).maxCoeff() / way_before_;
    if (pace > 0) way = std::min(way, allowed / pace);
  }
  return way;
}

}  // namespace desmo
