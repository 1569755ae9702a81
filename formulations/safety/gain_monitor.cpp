#include "formulations/safety/gain_monitor.h"

#include <algorithm>
#include <cmath>

#include "formulations/accuracy/scales.h"

namespace desmo {

namespace {

/// Groups that hardly follow their drivers are compared with this part of the one that does most.
constexpr double least_gain = 0.01;
/// Drivers slower than this, relative to their fastest, tell nothing of what follows them.
constexpr double at_rest = 1e-6;

}  // namespace

GainMonitor::GainMonitor(const Mechanism& m, std::span<const Level> levels)
    : mechanism_(m),
      group_(m.coordinates()),
      unit_(Eigen::ArrayXd::Zero(m.coordinates())),
      of_drivers_(unit_),
      weight_(unit_),
      rate_(unit_),
      last_q_(unit_),
      gain_(m.groups.size()) {
  const std::vector<double> magnitude = natural_magnitudes(m);
  const std::vector<bool> driven = independent_coordinates(m);
  const std::vector<EntityId> entity = entity_of_coordinate(m);
  const bool rates = std::ranges::any_of(levels, [](Level l) { return l >= Level::velocity; });
  for (int i = 0; i < m.coordinates(); ++i) {
    group_[i] = m.entities[entity[i]].group;
    if (!rates || levels[i] >= Level::velocity)
      (driven[i] ? of_drivers_ : unit_)[i] = 1 / magnitude[i];
  }
}

void GainMonitor::rate_at(const Instant& instant) {
  const auto of = [](std::span<const double> values) {
    return Eigen::Map<const Eigen::ArrayXd>(values.data(),
                                            static_cast<Eigen::Index>(values.size()));
  };
  if (!instant.qd.empty()) {
    rate_ = of(instant.qd).abs();
  } else {
    if (started_)
      rate_ = (of(instant.q) - last_q_).abs();
    else
      rate_.setZero();
    last_q_ = of(instant.q);
  }
  started_ = true;
}

double GainMonitor::drivers_rate() const { return (rate_ * of_drivers_).maxCoeff(); }

double GainMonitor::growth(const Instant& instant) {
  if (rate_.size() == 0) return 1;
  rate_at(instant);
  const double drivers = drivers_rate();
  fastest_ = std::max(fastest_, drivers);
  if (!(drivers > at_rest * fastest_)) return 1;
  return std::max(1.0, (rate_ * weight_).maxCoeff() / drivers);
}

void GainMonitor::reset(ScaledSystem& system) {
  if (rate_.size() == 0) return;
  std::ranges::fill(gain_, 0.0);
  double largest = 0;
  const auto at_least = [&](int i, double gain) {
    double& of_group = gain_[group_[i]];
    if (gain > of_group) of_group = gain;
    if (gain > largest) largest = gain;
  };
  const Eigen::ArrayXd& gains = system.gains();
  for (int j = 0; j < system.size(); ++j)
    if (const int i = system.unknowns()[j]; unit_[i] > 0) at_least(i, std::abs(gains[j]));
  if (const double drivers = drivers_rate(); drivers > at_rest * fastest_)
    for (const int i : system.unknowns())
      if (unit_[i] > 0) at_least(i, rate_[i] * unit_[i] / drivers);
  for (int i = 0; i < weight_.size(); ++i)
    if (unit_[i] > 0)
      weight_[i] = largest > 0 ? unit_[i] / std::max(gain_[group_[i]], least_gain * largest) : 0;
}

}  // namespace desmo
