#pragma once

#include <array>
#include <span>
#include <vector>

#include "formulations/base/index_range.h"

namespace desmo {

/// The rates of some coordinates at the last four instants, and a prediction from them. It
/// integrates the polynomial through their q̇ and q̈ from the last position on, as Adams and
/// Bashforth do with first derivatives. For a step of h from the last instant, number 0:
///   q = q₀ + Σ_j (h β_j q̇_j + h² γ_j q̈_j).
/// Polynomials q up to degree 8 are predicted exactly, except for rounding. Only the last position
/// enters, so errors of positions are not magnified. A prediction from several positions magnifies
/// them.
class RateHistory {
 public:
  static constexpr int instants = 4;

  /// ranges: those of the coordinates, ascending.
  explicit RateHistory(std::span<const IndexRange> ranges);

  void forget() { known_ = 0, newest_ = 0; }
  /// Remembers the rates of the last instant, and predicts the positions after a step.
  /// - interval: time from the instant remembered before to the last one [s]
  /// - h: the step [s]
  /// - last, qd, qdd: positions and rates of the last instant
  /// - q: overwritten by the predicted positions; may be `last`
  /// Returns false and leaves q alone where fewer than four instants are known, h is 0, intervals
  /// have different signs, or one is short compared with h (max_step_growth).
  bool predict(double interval, double h, const double* last, const double* qd, const double* qdd,
               double* q);

 private:
  /// Intervals [s] before the last instant, before the one before it, and so on.
  using Intervals = std::array<double, instants - 1>;
  /// Weights of the four instants, the oldest first, then of the three oldest again. `rates_` is a
  /// ring. Thanks to the repetition, elements 3 − newest_ … 6 − newest_ are the weights in its
  /// order.
  using Weights = std::array<double, 2 * instants - 1>;
  bool weigh(double h);
  struct Change;
  template <std::size_t block>
  void remember(const double* qd, const double* qdd);
  template <std::size_t block>
  void write_predicted(const Change& change, const double* last, double* q);

  int block_;                  // number of coordinates in a block: 1, or a number of lanes
  std::vector<int> blocks_;    // first coordinate of each block
  std::vector<double> rates_;  // q̇, then q̈, of each instant, in a ring
  std::size_t newest_ = 0;     // place of the last instant in the ring
  Intervals intervals_{};      // [s]
  int known_ = 0;
  Intervals weighed_{};  // intervals of beta_ and gamma_, divided by the step; zeros: none
  Weights beta_{}, gamma_{};
  std::vector<double> changes_;  // workspace: change of each coordinate in a step
};

}  // namespace desmo
