#pragma once

#include <Eigen/Core>
#include <vector>

#include "formulations/formulation.h"
#include "formulations/safety/scaled_system.h"

namespace desmo {

/// By how much the rates of unknowns have grown, relative to those of the drivers, since the last
/// assessment: the largest factor of any group. Where rates are not solved, differences from the
/// instant before stand for them.
class GainMonitor {
 public:
  GainMonitor(const Mechanism& mechanism, std::span<const Level> levels);

  /// At least 1; 1 where no driver moves.
  double growth(const Instant& instant);
  /// The instant of the last growth() is the one to compare with. system: with factors at it.
  void reset(ScaledSystem& system);

 private:
  double drivers_rate() const;
  void rate_at(const Instant& instant);

  const Mechanism& mechanism_;
  std::vector<GroupId> group_;  // of each coordinate
  Eigen::ArrayXd unit_;         // 1 over magnitude of the unknowns whose rates are watched, or 0
  Eigen::ArrayXd of_drivers_;   // 1 over magnitude of driven coordinates, or 0
  Eigen::ArrayXd weight_;       // unit over the largest gain of the group
  Eigen::ArrayXd rate_, last_q_;
  std::vector<double> gain_;  // of each group
  double fastest_ = 0;        // of the drivers so far
  bool started_ = false;
};

}  // namespace desmo
