#include "formulations/verification/monitor/sensitivity_monitor.h"

#include <algorithm>
#include <cmath>

namespace desmo {

namespace {

/// Groups that hardly follow their drivers are compared with this part of the one that does most.
constexpr double min_sensitivity = 0.01;
/// Drivers slower than this, relative to their fastest, tell nothing of what follows them.
constexpr double sensitivity_at_rest = 1e-6;

Eigen::Map<const Eigen::ArrayXd> as_array(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

}  // namespace

SensitivityMonitor::SensitivityMonitor(const Model& m, std::span<const Level> levels,
                                       std::span<const double> magnitude)
    : group_(m.coordinates()),
      unit_(Eigen::ArrayXd::Zero(m.coordinates())),
      weight_(unit_),
      difference_(unit_),
      sensitivity_(m.groups.size()) {
  const std::vector<bool> driven = independent_coordinates(m);
  const std::vector<EntityId> entity = entity_of_coordinate(m);
  const bool has_rates = std::ranges::any_of(levels, [](Level l) { return l > Level::position; });
  for (int i = 0; i < m.coordinates(); ++i) {
    group_[i] = m.entities[entity[i]].group;
    if (has_rates && levels[i] == Level::position) continue;
    if (driven[i])
      drivers_.push_back({i, 1 / magnitude[i]});
    else
      unit_[i] = 1 / magnitude[i];
  }
}

std::span<const double> SensitivityMonitor::rates(const Instant& instant) const {
  if (!instant.qd.empty()) return instant.qd;
  return {difference_.data(), static_cast<std::size_t>(difference_.size())};
}

double SensitivityMonitor::of_drivers(std::span<const double> rates) const {
  double largest = 0;
  for (const auto& [i, unit] : drivers_) largest = std::max(largest, std::abs(rates[i]) * unit);
  return largest;
}

double SensitivityMonitor::growth(const Instant& instant, std::optional<double> fastest) {
  if (unit_.size() == 0) return 1;
  if (instant.qd.empty()) {
    if (last_.size() > 0) difference_ = as_array(instant.q) - last_;
    last_ = as_array(instant.q);
  }
  const std::span<const double> rate = rates(instant);
  const double drivers = of_drivers(rate);
  fastest_ = std::max(fastest_, drivers);
  if (!instant.qd.empty())
    compare_drivers(drivers, instant.qdd.empty() ? 0 : of_drivers(instant.qdd));
  const bool moved = moves_;
  moves_ = drivers > sensitivity_at_rest * fastest_;
  if (!moves_) return moved ? INFINITY : 1;
  if (!fastest) fastest = (as_array(rate).abs() * weight_).maxCoeff();
  return std::max(1.0, *fastest / drivers);
}

void SensitivityMonitor::compare_drivers(double rates, double second) {
  drivers_now_ = {1, rates, std::max(rates * rates, second)};
  for (const Level l : {Level::velocity, Level::acceleration}) {
    max_drivers_[l] = std::max(max_drivers_[l], drivers_now_[l]);
    const double least = sensitivity_at_rest * max_drivers_[l];
    driver_growth_[l] = std::max(1.0, drivers_now_[l] / std::max(drivers_then_[l], least));
  }
}

void SensitivityMonitor::reset(const Instant& instant, ScaledSystem& system) {
  drivers_then_ = drivers_now_;
  std::ranges::fill(sensitivity_, 0.0);
  max_ = 0;
  const auto at_least = [&](int i, double sensitivity) {
    sensitivity_[group_[i]] = std::max(sensitivity_[group_[i]], sensitivity);
    max_ = std::max(max_, sensitivity);
  };
  const Eigen::ArrayXd& sensitivities = system.sensitivities();
  const std::span<const double> rate = rates(instant);
  const double drivers = of_drivers(rate);
  for (int j = 0; j < system.size(); ++j) {
    const int i = system.unknowns()[j];
    if (unit_[i] == 0) continue;
    at_least(i, std::abs(sensitivities[j]));
    if (moves_) at_least(i, std::abs(rate[i]) * unit_[i] / drivers);
  }
  for (int i = 0; i < weight_.size(); ++i)
    weight_[i] =
        max_ > 0 ? unit_[i] / std::max(sensitivity_[group_[i]], min_sensitivity * max_) : 0;
}

}  // namespace desmo
