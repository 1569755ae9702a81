#pragma once

#include <memory>
#include <span>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/base/index_range.h"
#include "formulations/base/observer.h"
#include "formulations/base/state.h"
#include "formulations/stepping/segment_solver.h"

namespace desmo {

/// Hands every instant of a grid to an observer, given every stride-th and the last of them, solved
/// at every level and in order of time. Solved ones are handed on as they are; those between are on
/// the quintic through q, q̇ and q̈ of the two solved about them (Hermite interpolation; as dense
/// output: Hairer, Nørsett & Wanner, Solving Ordinary Differential Equations I, II.6). Where the
/// motion is smooth its errors are O(h⁶) in position, O(h⁵) in velocity, O(h⁴) in acceleration,
/// h being the time from one solved instant to the next. Errors of the solved positions go into
/// velocities divided by h and into accelerations divided by h².
class DenseOutput final : public Observer {
 public:
  /// grid: of all instants. coordinates: their number in an instant; those that the request names
  /// are interpolated. The observer outlives this.
  DenseOutput(const TimeGrid& grid, int stride, const Request& request, int coordinates,
              Observer& observer);

  /// The index counts solved instants. Allocates nothing.
  Flow observe(const Instant& solved) noexcept override;

  /// Returns how many instants the observer was given.
  int delivered() const { return delivered_; }

 private:
  /// Weights of what is known at both ends of an interval.
  struct Weights {
    double q0, change, v0, v1, a0, a1;  // of q₀, q₁ − q₀, q̇₀, q̇₁, q̈₀, q̈₁
  };

  static Weights of_position(double s, double h);
  static Weights of_velocity(double s, double h);
  static Weights of_acceleration(double s, double h);

  Flow interpolate_to(const Instant& next, int index);
  void combine(Weights w, const Instant& next, std::vector<double>& result) const;
  Flow hand_on(const Instant& instant);
  void keep(const Instant& solved);

  const TimeGrid grid_;
  const int stride_;
  const Level level_;
  const std::vector<IndexRange> ranges_;
  const OutputWriter output_;
  Observer& observer_;
  State last_;           // the instant solved last
  int last_index_ = -1;  // of it, in the grid
  State between_;
  int delivered_ = 0;
};

/// A formulation that, in a motion, solves every stride-th instant and the last one, and
/// interpolates the others (see DenseOutput). Single instants are solved by the formulation inside.
class Interpolated final : public FormulationCore {
 public:
  /// stride: 2 … max_stride.
  Interpolated(std::unique_ptr<SegmentSolver> inner, int stride);

  Summary assemble_at(double t, Level level) override { return inner_->assemble(t, level); }
  Summary step_to(double t, Level level) override { return inner_->step(t, level); }
  Summary run(const TimeGrid& grid, const Request& request, Observer& observer) override;
  bool start_at(std::span<const double> q, double t) override { return inner_->start_at(q, t); }
  void solve_only(std::span<const Level>) override {}
  long run_by_steps() const override { return inner_->run_by_steps(); }
  const std::vector<DefinedPart>& parts() const override { return inner_->parts(); }
  const State& state() const override { return inner_->state(); }

 private:
  std::unique_ptr<SegmentSolver> inner_;
  int stride_;
};

}  // namespace desmo
