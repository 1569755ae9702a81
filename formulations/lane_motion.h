#pragma once

#include <array>
#include <span>
#include <vector>

#include "cases/motion.h"

namespace desmo {

/// z, ż and z̈ of a motion at several times (s), a multiple of four: at each what sample() gives,
/// but for rounding.
void sample_lanes(const Motion& motion, std::span<const double> times, double* position,
                  double* velocity, double* acceleration);

/// Several motions at one time, as all drivers of a mechanism are wanted at each instant: the sines
/// and cosines of harmonic sums are taken four at a time.
class MotionSampler {
 public:
  /// The motions outlive the sampler, unchanged.
  explicit MotionSampler(std::vector<const Motion*> motions);

  /// z, ż and z̈ of each motion at time t (s), what sample() gives but for rounding. Until the next
  /// call.
  std::span<const MotionSample<double>> operator()(double t);

 private:
  /// Terms of harmonic sums, of one or of several. Where there are fewer, amplitudes are zero.
  struct Terms {
    std::array<double, 4> amplitude{}, angular_frequency{}, phase{};
    std::array<int, 4> motion{};
  };
  struct Mean {
    int motion;
    double value;
  };

  std::vector<const Motion*> motions_;
  std::vector<int> others_;  // motions that are no harmonic sum
  std::vector<Mean> means_;  // of those that are
  std::vector<Terms> terms_;
  std::vector<MotionSample<double>> samples_;
};

}  // namespace desmo
