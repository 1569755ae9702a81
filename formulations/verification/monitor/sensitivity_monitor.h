#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/verification/assessment/scaled_system.h"

namespace desmo {

/// Monitor of the ratio of the unknowns' rates to those of the drivers, in the group where it has
/// grown most since the last assessment. Where rates are not solved, it uses differences from the
/// last instant.
class SensitivityMonitor {
 public:
  /// levels: the level up to which each coordinate is solved. magnitudes: (coordinates).
  SensitivityMonitor(const Model& model, std::span<const Level> levels,
                     std::span<const double> magnitudes);

  /// Returns the growth since reset(), at least 1; instants come in order of time. fastest: the
  /// largest rate, times weights(), where it is known (StepMeasures). Drivers that
  /// stop leave nothing to compare with: the first instant at which none moves has infinite growth.
  /// Later ones have 1, since they equal it.
  double growth(const Instant& instant, std::optional<double> fastest = {});
  /// Returns the growth of the drivers' motion since reset(), at least 1:
  /// - position: 1
  /// - velocity: growth of their rates
  /// - acceleration: growth of the larger of squared rates and second derivatives
  const PerLevel<double>& driver_growth() const { return driver_growth_; }
  /// Returns the largest rate of the drivers at the instant of the last growth(), in magnitudes.
  double drivers() const { return drivers_now_.velocity; }
  /// Makes the instant of the last growth() the one to compare with. system: factorised at it.
  void reset(const Instant& instant, ScaledSystem& system);
  /// Returns, for each unknown, 1 over its group's movement when the drivers move by their
  /// magnitudes.
  const Eigen::ArrayXd& weights() const { return weight_; }
  /// Returns the largest movement of any unknown, in magnitudes, when the drivers move by theirs.
  double largest() const { return max_; }

 private:
  std::span<const double> rates(const Instant& instant) const;
  double of_drivers(std::span<const double> rates) const;
  void compare_drivers(double rates, double second);

  struct Driven {
    int coordinate;
    double unit;  // 1 / magnitude
  };
  std::vector<Driven> drivers_;
  std::vector<GroupId> group_;  // group of each coordinate
  Eigen::ArrayXd unit_;         // 1 / magnitude of unknowns whose rates are monitored, else 0
  Eigen::ArrayXd weight_;       // unit_ over the largest sensitivity of the group
  Eigen::ArrayXd difference_, last_;
  std::vector<double> sensitivity_;  // sensitivity of each group
  double max_ = 0;                   // largest of sensitivity_
  double fastest_ = 0;               // largest rate of the drivers so far
  bool moves_ = false;               // a driver moved at the last instant
  PerLevel<double> drivers_now_{}, drivers_then_{}, max_drivers_{};  // their motion
  PerLevel<double> driver_growth_{1, 1, 1};
};

}  // namespace desmo
