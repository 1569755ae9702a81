#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/verification/monitor/scaled_system.h"

namespace desmo {

/// By how much the rates of unknowns have grown, relative to those of the drivers, since the last
/// assessment: the largest factor of any group. Where rates are not solved, differences from the
/// instant before stand for them.
class SensitivityMonitor {
 public:
  /// levels: as far as each coordinate is solved. magnitudes: of each coordinate.
  SensitivityMonitor(const Model& model, std::span<const Level> levels,
                     std::span<const double> magnitudes);

  /// At least 1. Where no driver moves there is nothing to compare with: infinite at the first such
  /// instant, 1 at the others, which are the same. Instants in order of time.
  double growth(const Instant& instant);
  /// The instant of the last growth() is the one to compare with. system: with factors at it.
  void reset(const Instant& instant, ScaledSystem& system);
  /// Of each unknown, 1 over what its group moves when the drivers move by their magnitudes.
  const Eigen::ArrayXd& weights() const { return weight_; }
  /// The largest of what any unknown moves then.
  double largest() const { return max_; }

 private:
  std::span<const double> rates(const Instant& instant) const;
  double of_drivers(std::span<const double> rates) const;

  struct Driven {
    int coordinate;
    double magnitude;
  };
  std::vector<Driven> drivers_;
  std::vector<GroupId> group_;  // of each coordinate
  Eigen::ArrayXd unit_;         // 1 over the magnitude of unknowns whose rates are watched, or 0
  Eigen::ArrayXd weight_;       // the same over the largest gain of the group
  Eigen::ArrayXd difference_, last_;
  std::vector<double> sensitivity_;  // of each group
  double max_ = 0;                   // of these
  double fastest_ = 0;               // of the drivers so far
  bool moves_ = false;               // one of them, at the last instant
};

}  // namespace desmo
