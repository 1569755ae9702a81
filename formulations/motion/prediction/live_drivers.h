#pragma once

#include <vector>

#include "formulations/base/lane_values.h"
#include "formulations/base/live_row.h"
#include "formulations/base/state.h"
#include "formulations/motion/prediction/motions_ahead.h"

namespace desmo {

/// The driver values of one step that are handed in, laid out as a row for those who read it.
class LiveDrivers {
 public:
  /// A number of the row: the driver (position in Model::drivers) and its coordinate in the
  /// state.
  struct Place {
    int driver, coordinate;
  };
  explicit LiveDrivers(std::vector<Place> places);

  /// Takes a row. start, from: time [s] and positions of the last instant, from where sub-steps go
  /// straight.
  void hand_in(const LiveRow& row, double start, const State& from);
  /// Ends the step.
  void hand_back() { is_handed_in_ = false; }
  bool is_handed_in() const { return is_handed_in_; }

  /// Returns the row at its own time and, at others, drivers that go straight from `start` to it at
  /// constant rates. Valid until the next call.
  MotionRow at(double t);

 private:
  std::vector<Place> places_;
  LaneState row_, between_;
  LaneValues from_;
  double time_ = 0, start_ = 0;  // s
  bool is_handed_in_ = false;
};

}  // namespace desmo
