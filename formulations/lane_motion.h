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

/// Several motions at one time, as all drivers of a mechanism are wanted at each instant: harmonic
/// sums are taken four at a time.
class MotionSampler {
 public:
  /// places: of each motion, where it belongs in the arrays that are written. The motions outlive
  /// the sampler, unchanged.
  MotionSampler(std::vector<const Motion*> motions, std::vector<int> places);

  /// Writes z, ż and z̈ of each motion at time t (s), what sample() gives but for rounding.
  void operator()(double t, double* z, double* zd, double* zdd) const;

 private:
  /// One of each of four sums. Where a sum has fewer, the amplitude is zero.
  struct Terms {
    std::array<double, 4> amplitude{}, angular_frequency{}, phase{};
  };
  struct Sums {
    std::array<double, 4> mean{};
    std::array<int, 4> place{};
    int size = 0;  // four, or what is left
    std::vector<Terms> terms;
  };
  Sums sums(std::span<const int> motions) const;

  std::vector<const Motion*> motions_;
  std::vector<int> places_;
  std::vector<int> others_;  // motions that are no harmonic sum
  std::vector<Sums> sums_;
};

}  // namespace desmo
