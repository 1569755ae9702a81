#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "formulations/formulation.h"
#include "formulations/motion/time_stepping.h"

namespace desmo {

/// Solves the segments of a motion known in advance at once. Each is entered by continuation from
/// the first position of the motion, and solved on its own; that all lie on one branch shows where
/// a segment ends and the next has begun (segments_meet).
class SegmentExecutor {
 public:
  virtual ~SegmentExecutor() = default;
  /// Hands every instant of the grid to an observer that lends memory and takes any order. state:
  /// the first instant, assembled; overwritten by the last, unless the observer stops the run.
  /// Returns nothing when the motion has to be solved step by step after all; the state and what
  /// the observer was given are then void.
  virtual std::optional<Summary> run(const TimeGrid& grid, const Request& request, State& state,
                                     Observer& observer) = 0;
  /// Leaves out levels, as Formulation::solve_only() does.
  virtual void solve_only(std::span<const Level>) {}
};

/// Returns whether a segment ended where the next had begun, at positions of one instant in
/// coordinate order: converged, they differ by far less than is allowed; on different branches, by
/// far more.
bool segments_meet(const Model& model, std::span<const double> ended,
                   std::span<const double> begun);

/// A formulation that solves the segments of a motion at once, in lanes or on threads, or, where
/// they do not meet, the motion step by step after all. Single instants are solved by steps.
class SegmentedFormulation final : public SegmentSolver {
 public:
  SegmentedFormulation(std::unique_ptr<TimeStepping> steps,
                       std::unique_ptr<SegmentExecutor> executor);

  Summary do_assemble(double t, Level level) override { return steps_->assemble(t, level); }
  Summary do_step(double t, Level level) override { return steps_->step(t, level); }
  Summary run(const TimeGrid& grid, const Request& request, Observer& observer) override;
  bool start_at(std::span<const double> q, double t) override { return steps_->start_at(q, t); }
  std::optional<Summary> run_on(const TimeGrid& grid, const Request& request,
                                Observer& observer) override;
  void do_solve_only(std::span<const Level> needed) override;
  long runs_without_segments() const override { return runs_without_segments_; }
  const std::vector<DefinedPart>& parts() const override { return steps_->parts(); }
  const State& state() const override { return steps_->state(); }

 private:
  std::unique_ptr<TimeStepping> steps_;
  std::unique_ptr<SegmentExecutor> executor_;
  State last_;  // the instant where the executor ended
  long runs_without_segments_ = 0;
};

}  // namespace desmo
