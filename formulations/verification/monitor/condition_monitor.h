#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/verification/assessment/scaled_system.h"

namespace desmo {

/// Monitors the growth of the condition number since the last assessment where rates do not show
/// it: a motion that just misses a change point is smooth. It solves x = A⁻¹ b for a fixed b
/// without pattern and compares ‖x‖∞ of each group with that of the assessment. Near a singular
/// position 1/‖x‖∞ falls to zero linearly with the distance. The solution needs factors, so it is
/// taken now and then (a *look*). The next look is due when, at the present pace, 1/‖x‖∞ would have
/// halved. It is due at the latest when the drivers have moved by 2 magnitudes, or four times the
/// distance between the last two looks.
class ConditionMonitor {
 public:
  /// system: the one of the model.
  ConditionMonitor(const Model& model, const ScaledSystem& system);

  /// Adds the drivers' way to an instant; instants come in order of time.
  void go_on(const Instant& instant);
  /// Returns whether the instant should be looked at.
  bool is_due() const { return way_ > 0 && way_ >= next_; }
  void look(const Instant& instant, ScaledSystem& system);
  /// Returns the growth, at least 1: that of the last look, extrapolated at the same pace; infinity
  /// where it was singular.
  double growth() const { return growth_ / (1 - fall_ * way_); }
  /// Makes this instant the one to compare with. system: factorised at it.
  void reset(ScaledSystem& system);

 private:
  void take(ScaledSystem& system);

  struct Driven {
    int coordinate;
    double unit;  // 1 over its magnitude
    double last = std::numeric_limits<double>::quiet_NaN();
  };
  std::vector<Driven> drivers_;
  std::vector<double> state_;
  std::vector<GroupId> group_;  // group of each unknown
  Eigen::ArrayXd right_, x_;    // b and x = A⁻¹ b
  Eigen::ArrayXd now_, then_;   // ‖x‖∞ of each group: last look, assessment
  Eigen::ArrayXd share_;        // then_ / now_ at the last look
  double growth_ = 1;
  double fall_ = 0, pace_ = 0;  // change of share_ per way: decrease since the last look, largest
  double way_ = 0, next_ = 0;  // drivers' way since the last look and until the next, in magnitudes
};

}  // namespace desmo
