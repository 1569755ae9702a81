#pragma once

#include <array>
#include <span>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/model/model.h"

namespace desmo {

/// Motions, and where the values of each are written: motion k at z[places[k]], and likewise in ż
/// and z̈.
struct PlacedMotions {
  std::vector<const Motion*> motions;
  std::vector<int> places;
};
/// Returns the motions of a model's drivers, each placed at its coordinate in the state. The model
/// outlives the result.
PlacedMotions driver_motions(const Model& model);
/// Returns motions placed one after the other, from place 0.
PlacedMotions in_order(std::vector<const Motion*> motions);

/// Strides of samples at several times. The sample of time number l, of a motion at `place`, goes
/// to index place · of_place + l · of_time.
struct SampleStrides {
  int of_place = 1, of_time = 1;  ///< at least one of them is 1
};
/// Lays the samples of a motion at all times next to each other, place after place.
inline SampleStrides side_by_side(int times) { return {.of_place = times}; }
/// Lays the samples of all motions at one time next to each other, in a row of this length.
inline SampleStrides in_rows(int of_row) { return {.of_time = of_row}; }

/// Samples several motions at one time or at several. A term a sin(ωt + φ) of a harmonic sum is
/// evaluated as a cos φ sin ωt + a sin φ cos ωt. So motions of one frequency share sine and cosine.
class MotionSampler {
 public:
  /// times: number of times in a call, one or a multiple of four. The motions outlive the sampler,
  /// unchanged.
  explicit MotionSampler(PlacedMotions placed, int times = 1, SampleStrides strides = {});

  /// Writes z, ż and z̈ of each motion at these times [s]: what sample() returns, except for
  /// rounding.
  void operator()(std::span<const double> times, double* z, double* zd, double* zdd);

 private:
  /// The terms of one angular frequency ω in four motions: of_sine sin ωt + of_cosine cos ωt. The
  /// factors are also stored multiplied by ω and by ω². A motion without the frequency has zeros.
  struct Term {
    int frequency;  // index of ω in frequencies_
    std::array<double, 4> of_sine{}, of_cosine{}, w_of_sine{}, w_of_cosine{}, w2_of_sine{},
        w2_of_cosine{};
  };
  /// Four motions, of the same frequencies where possible. Where fewer are left, the last is
  /// repeated.
  struct Sums {
    int size;  // number of motions without the repeated ones
    std::array<int, 4> place;
    bool in_order;  // the four places follow each other
    std::array<double, 4> mean;
    std::vector<Term> terms;
  };

  Sums sums(std::span<const int> motions);
  int frequency(double w);
  void find_waves(std::span<const double> times);
  void sample_others(std::span<const double> times, double* z, double* zd, double* zdd) const;
  void add_up_by_four_motions(double* z, double* zd, double* zdd) const;
  void add_up_by_four_times(double* z, double* zd, double* zdd) const;

  PlacedMotions placed_;
  int times_;
  SampleStrides strides_;
  std::vector<int> others_;  // positions of motions that are no harmonic sum
  std::vector<Sums> sums_;
  // distinct angular frequencies [rad/s]; where calls have one time, padded with zeros to a
  // multiple of four
  std::vector<double> frequencies_;
  std::vector<double> sines_, cosines_;  // sine and cosine of ωt: by frequency, then time
};

}  // namespace desmo
