#pragma once

#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/base/index_range.h"
#include "formulations/base/observer.h"
#include "formulations/base/output_writer.h"
#include "formulations/base/state.h"

namespace desmo {

/// Observer that takes every stride-th instant of a grid and the last one, and hands every instant
/// to another observer. It takes instants in order of time, solved at every level, and hands these
/// on without the levels that the request does not ask for. Instants between two solved ones lie on
/// the quintic through q, q̇ and q̈ of both (Hermite interpolation; as dense output: Hairer, Nørsett
/// & Wanner, Solving Ordinary Differential Equations I, II.6). With h the time between two solved
/// instants, errors of a smooth motion are O(h⁶) in position, O(h⁵) in velocity and O(h⁴) in
/// acceleration. Errors of the solved positions enter velocities divided by h, and accelerations
/// divided by h².
class DenseOutput final : public Observer {
 public:
  /// grid: all instants, solved or not. coordinates: their number in an instant; those that the
  /// request names are interpolated. The observer outlives this.
  DenseOutput(const TimeGrid& grid, int stride, const Request& request, int coordinates,
              Observer& observer);

  /// Takes a solved instant, whose index counts solved instants alone. Where the observer stops at
  /// an interpolated instant, the solved instant is not handed on. Allocates nothing.
  Flow observe(const Instant& solved) noexcept override;

  /// Returns how many instants the observer was given.
  int delivered() const { return delivered_; }

 private:
  /// Weights of the values at both ends of an interval.
  struct Weights {
    double q0, change, v0, v1, a0, a1;  // weights of q₀, q₁ − q₀, q̇₀, q̇₁, q̈₀, q̈₁
  };

  static Weights of_position(double s, double h);
  static Weights of_velocity(double s, double h);
  static Weights of_acceleration(double s, double h);

  Flow interpolate_to(const Instant& next);
  void combine(Weights w, const Instant& next, std::vector<double>& result) const;
  Flow hand_on(const Instant& instant);
  void keep(const Instant& solved);

  const TimeGrid grid_;
  const int stride_;
  const Level level_;
  const std::vector<IndexRange> ranges_;
  const OutputWriter output_;
  Observer& observer_;
  State last_;           // the instant solved most recently
  int last_index_ = -1;  // index in the grid of the instant solved most recently; −1: none
  State between_;
  int delivered_ = 0;
};

}  // namespace desmo
