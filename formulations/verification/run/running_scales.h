#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/scaling/scales.h"

namespace desmo {

/// Returns times [s], spread evenly over a grid, at which drivers are sampled before the run.
std::vector<double> looks_ahead(const TimeGrid& grid);

/// Scales of a motion (see Scales) while it is being solved. They start from the drivers' rates and
/// grow with the instants so far.
class RunningScales {
 public:
  /// given: scales that are known, and do not change. of_motion: false gives the scales of the
  /// instant included last alone.
  RunningScales(const Model& model, const TimeGrid& grid, const std::optional<Scales>& given = {},
                bool of_motion = true);

  /// Includes an instant. Returns whether a scale has grown.
  bool take(const Instant& instant);
  /// Excludes the instant included last, if its time is `time`: it will be solved again.
  void take_back(double time);
  const Scales& current() const { return scales_; }
  /// Returns the scales that would include an instant, without keeping it: it may turn out wrong.
  Scales with(const Instant& instant) const;

 private:
  bool are_given_, are_of_motion_;
  bool grow(Scales& seen, const Instant& instant) const;
  static Scales completed(Scales seen);

  struct Moving {
    int first, size;  // coordinates
    bool is_length;
  };
  std::vector<Moving> moving_;
  Scales seen_, scales_;
  Scales before_;  // without the instant included last
  double last_time_ = NAN;
};

}  // namespace desmo
