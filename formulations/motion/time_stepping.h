#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "formulations/base/live_row.h"
#include "formulations/base/output_writer.h"
#include "formulations/base/part.h"
#include "formulations/formulation.h"
#include "formulations/model/partition.h"
#include "formulations/motion/driver_continuation.h"
#include "formulations/motion/part_sequence.h"
#include "formulations/motion/prediction/driver_source.h"
#include "formulations/motion/prediction/state_predictor.h"
#include "formulations/motion/segments.h"

namespace desmo {

/// A formulation that steps through time, the paper's Fig. 2a: at each instant the drivers, a
/// prediction, and the parts in order. Motions are in time_stepping.cpp, what segments and a stride
/// add to them in segments.cpp and dense_output.cpp; the first instant, single steps and live rows
/// in single_instants.cpp.
class TimeStepping final : public Formulation {
 public:
  /// settings: the same that the parts were made with. executor: solves motions in segments; null:
  /// all motions are solved step by step, as are those whose segments do not meet. The model
  /// outlives this object.
  TimeStepping(const Model& model, std::vector<DefinedPart> parts, const Settings& settings,
               std::unique_ptr<SegmentExecutor> executor = nullptr);

  Summary assemble(double t, Level level) override;
  Summary step(double t, Level level) override;
  Summary run(const TimeGrid& grid, const Request& request, Observer& observer) override;
  void solve_only(std::span<const Level> needed) override;

  /// Makes each assembly begin at the drawing and go on in short steps of the drivers, where these
  /// are drawn elsewhere. Newton's method alone may end on another branch. Where the steps are
  /// blocked, it is used alone.
  void assemble_in_short_steps() { assembles_in_short_steps_ = true; }

  /// Goes to time t [s] of the motion without solving the instants before, by continuation. Drivers
  /// move linearly from the positions q to where they are at t. q: Model::coordinates() values or
  /// more, solved at another instant. The next step goes on from the position at t. Returns false
  /// where the position cannot be reached; the next step then assembles.
  bool start_at(std::span<const double> q, double t);

  /// Runs like run() without a stride, from the position that start_at() reached. Returns nothing
  /// where an instant could not be solved or segments do not meet. All that the observer was given
  /// is then void.
  std::optional<Summary> run_on(const TimeGrid& grid, const Request& request, Observer& observer);

  /// Solves an instant like step(), with driver values from a row instead of the motions. Takes at
  /// most max_sub_steps sub-steps, in which drivers move linearly from their last positions to the
  /// row. Takes nothing from the heap unless it assembles or follows a run(). So a failure names no
  /// constraint, and the group only where the failed part has a single one. The row is not checked.
  /// LiveRun checks it, and can prove the result.
  Summary step_to_row(const LiveRow& row, Level level, int max_sub_steps);

  /// Returns to positions q that were solved before, at time t [s]; the next row starts there.
  /// Rates become unknown. q: Model::coordinates() values or more; empty: the next row is
  /// assembled.
  void return_to(std::span<const double> q, double t);

  /// Returns the instant solved last, the fixed entities included.
  const State& state() const { return now_.state; }
  /// Returns the parts in the order of solution.
  const std::vector<DefinedPart>& parts() const { return sequence_.parts(); }
  /// Returns how often a motion that was to be solved in segments was solved step by step instead.
  long runs_without_segments() const { return runs_without_segments_; }

 private:
  static constexpr int unlimited = std::numeric_limits<int>::max();

  /// An instant and the level to which it was solved.
  struct SolvedState {
    State state{};
    double time = 0;  // [s]
    // nothing: rates are unknown, and a prediction uses its positions only
    std::optional<Level> level{};
    void forget() { time = 0, level.reset(); }
  };

  /// The first part of a step that could not be solved.
  struct Failure {
    int part = -1;
    std::vector<double> q{};  // state from which the diagnosis solves it again
  };

  /// The coordinates of each instant that are read outside the parts.
  struct ReadCoordinates {
    std::vector<int> coordinates;  // empty: all
    bool lent;  // they are read in memory that the observer lends; false: in the state
  };

  void prepare();
  void forget();
  void forget_steps();
  void begin_at(std::span<const double> q);
  void set_read_outside(const Request& request, bool lent = false);
  Summary run_with_stride(const TimeGrid& grid, const Request& request, Observer& observer);
  Summary solve_all(const TimeGrid& grid, const Request& request, Observer& observer);
  std::optional<Summary> solve_segments(const TimeGrid& grid, const Request& request,
                                        Observer& observer);
  Summary take_steps(const TimeGrid& grid, const Request& request, Observer& observer);
  Summary solve_at(double t, Level level);
  Summary assemble_or_step(double t, Level level, int max_sub_steps = unlimited);
  Summary sub_step(double from, double t, Level level, int max_sub_steps, Summary total);
  Summary assemble_from_estimate(double t, Level level);
  /// Continues the present positions to where the drivers are at time t [s]: see
  /// continue_drivers_to(). Restores the state where that is not possible.
  ContinuationEnd continue_to(double t, bool in_short_steps = false);
  void take_nearest_turns();
  bool is_drawn_at(double t);
  State drivers_at(double t);
  void note_failure(int part);
  void find_culprit_of_failure(Summary& summary) const;
  Flow deliver(int index, double t, const Summary& step, Level level, Observer& observer);

  PartSequence sequence_;
  DriverSource drivers_;
  StatePredictor predict_;
  std::optional<ReadCoordinates> read_outside_;
  OutputWriter output_;        // writes what no part delivers
  SolvedState now_, before_;   // the instant solved last, and the one before it
  std::vector<double> start_;  // positions at the start of a step that is taken in sub-steps
  Failure failure_;
  bool assembles_in_short_steps_ = false;
  bool assembled_ = false;  // now_ has positions at its time, whatever is known of rates
  std::unique_ptr<SegmentExecutor> executor_;
  State ended_;  // the last instant that the executor solved
  long runs_without_segments_ = 0;
};

}  // namespace desmo
