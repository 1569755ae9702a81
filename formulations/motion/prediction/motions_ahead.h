#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/base/lane_values.h"
#include "formulations/motion/prediction/motion_sampler.h"

namespace desmo {

/// z, ż and z̈ of several motions at one time, in their order.
struct MotionRow {
  const double *z = nullptr, *zd = nullptr, *zdd = nullptr;

  /// Returns the row without its first `first` numbers.
  MotionRow from(std::size_t first) const { return {z + first, zd + first, zdd + first}; }
};

/// Returns the length of a row for this number of values: whole cache lines, at least one.
int whole_lines(std::size_t numbers);

/// Sampler of several motions, at one time after the other. Where the times are known in advance,
/// as those of a grid, it samples eight instants at once. Eight sines cost hardly more than one,
/// and a step need not wait for them.
class MotionsAhead {
 public:
  /// motions: in the order of a row, repeats allowed. They outlive this, unchanged.
  explicit MotionsAhead(std::vector<const Motion*> motions);

  /// Announces that times are those of this grid, in order from the first. Times between them are
  /// sampled singly, and so are all after a skipped instant.
  void expect(const TimeGrid& grid);

  /// Returns the row at time t [s], valid until the next call.
  MotionRow operator()(double t);

 private:
  static constexpr int together = 8;
  void sample_next();
  MotionRow row(std::size_t k) const {
    return {&samples_.q[k * of_row_], &samples_.qd[k * of_row_], &samples_.qdd[k * of_row_]};
  }

  int of_row_;  // length of a row: whole cache lines
  MotionSampler alone_, ahead_;
  TimeGrid grid_{};
  int sampled_ = 0;                       // number of instants of the grid that were sampled
  std::size_t next_ = together;           // the next of the eight sampled last; together: none
  std::array<double, together> times_{};  // times of these eight [s]
  LaneState samples_;  // rows of these eight, then of a time that was sampled alone
};

}  // namespace desmo
