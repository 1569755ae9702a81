#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "cases/motion.h"
#include "formulations/lane_motion.h"

namespace desmo {

/// Several motions at one time after the other. Where these times are known, as those of a grid
/// are, a few instants are sampled at once, before the first of them: sines cost hardly more of
/// eight times than of one, and a step need not wait for them.
class MotionsAhead {
 public:
  /// As those of MotionSampler.
  explicit MotionsAhead(const PlacedMotions& placed);

  /// From now on times are those of this grid, in order from the first. What comes between them is
  /// sampled alone, and once they are left out, all that follow.
  void expect(const TimeGrid& grid);

  /// As MotionSampler, at time t (s).
  void operator()(double t, double* z, double* zd, double* zdd);

 private:
  static constexpr int together = 8;
  void sample_next();

  std::vector<int> places_;
  MotionSampler alone_, ahead_;
  TimeGrid grid_{};
  int sampled_ = 0;                       // instants of the grid
  std::size_t next_ = together;           // of those sampled last
  std::array<double, together> times_{};  // theirs, s
  std::vector<double> z_, zd_, zdd_;      // of each motion at each
};

}  // namespace desmo
