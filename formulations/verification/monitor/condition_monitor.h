#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/verification/monitor/scaled_system.h"

namespace desmo {

/// By how much the condition number has grown since the last assessment, where rates do not show
/// it: a motion all but through a change point is as smooth as any. Seen is what A⁻¹ makes of a
/// right-hand side that no motion has, of each group: near a singular position the inverse of it
/// falls to zero as the distance does, at an even pace. That takes factors, so it is looked at now
/// and then: where, at the pace of the last looks, it would have changed by half, and not later
/// than the drivers have gone a way of 2, or four times that between the last two looks.
class ConditionMonitor {
 public:
  /// system: that of the mechanism.
  ConditionMonitor(const Model& model, const ScaledSystem& system);

  /// The motion has come to that instant. Instants in order of time.
  void go_on(const Instant& instant);
  /// Whether it is time for a look at it.
  bool is_due() const { return way_ > 0 && way_ >= next_; }
  void look(const Instant& instant, ScaledSystem& system);
  /// At least 1: that of the last look, gone on at the same pace; infinite where it was singular.
  double growth() const { return growth_ / (1 - fall_ * way_); }
  /// The instant is the one to compare with. system: with factors at it.
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
  std::vector<GroupId> group_;  // of each unknown
  Eigen::ArrayXd right_, x_;    // the right-hand side, and what A⁻¹ makes of it
  Eigen::ArrayXd now_, then_;   // ‖x‖∞ of each group: at the last look, and to compare with
  Eigen::ArrayXd share_;        // then_ over now_, at the last look
  double growth_ = 1;
  double fall_ = 0, pace_ = 0;  // of shares over a way of 1: since the last look, of any change
  double way_ = 0, next_ = 0;   // of the drivers since the last look, in magnitudes; to the next
};

}  // namespace desmo
