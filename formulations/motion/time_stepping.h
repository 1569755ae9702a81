#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "formulations/base/output_writer.h"
#include "formulations/motion/driver_continuation.h"
#include "formulations/motion/formulation_core.h"
#include "formulations/motion/part_sequence.h"
#include "formulations/motion/prediction/driver_source.h"
#include "formulations/motion/prediction/state_predictor.h"
#include "formulations/motion/segments.h"

namespace desmo {

/// A formulation that steps through time, the paper's Fig. 2a: at each instant the drivers, a
/// prediction, and the parts in order. Motions are in time_stepping.cpp, what segments and a stride
/// add to them in segments.cpp and dense_output.cpp; the first instant, single steps and live rows
/// in single_instants.cpp.
class TimeStepping final : public FormulationCore, private LiveSteps {
 public:
  /// settings: the same that the parts were made with. executor: solves the segments of a motion at
  /// once; where they do not meet, or without it, steps solve the motion. The model outlives this
  /// object.
  TimeStepping(const Model& model, std::vector<DefinedPart> parts, const Settings& settings,
               std::unique_ptr<SegmentExecutor> executor = nullptr);

  Summary do_assemble(double t, Level level) override;
  Summary do_step(double t, Level level) override;
  Summary run(const TimeGrid& grid, const Request& request, Observer& observer) override;
  bool start_at(std::span<const double> q, double t) override;
  /// Runs like run(), but starts at the position that start_at() reached. Returns nothing where an
  /// instant could not be solved or segments do not meet; all that the observer was given is then
  /// void.
  std::optional<Summary> run_on(const TimeGrid& grid, const Request& request, Observer& observer);
  void do_solve_only(std::span<const Level> needed) override;
  long runs_without_segments() const override { return runs_without_segments_; }
  LiveSteps* live() override { return this; }
  const std::vector<DefinedPart>& parts() const override { return sequence_.parts(); }
  const State& state() const override { return now_.state; }

 private:
  static constexpr int unlimited = std::numeric_limits<int>::max();

  /// An instant, and how far it was solved.
  struct SolvedState {
    State state{};
    double time = 0;               // s
    std::optional<Level> level{};  // nothing: rates are unknown, and nothing is predicted from it
    void forget() { time = 0, level.reset(); }
  };

  /// The first part of a step that could not be solved.
  struct Failure {
    int part = -1;
    std::vector<double> q{};  // positions in the state from which it is solved again
  };

  /// The coordinates of each instant that are read outside the parts.
  struct ReadCoordinates {
    std::vector<int> coordinates;  // empty: all
    bool lent;  // they are read in memory that the observer lends; false: in the state
  };

  Summary step_to_row(const LiveRow& row, Level level, int max_sub_steps) override;
  void return_to(std::span<const double> q, double t) override;

  void prepare();
  void forget();
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
  /// Leads the drivers continuously from the present positions to time t [s]. Restores the state
  /// where that is not possible.
  ContinuationEnd lead_drivers_to(double t);
  void note_failure(int part);
  void find_culprit_of_failure(Summary& summary) const;
  Flow deliver(int index, double t, const Summary& step, Level level, Observer& observer);

  PartSequence sequence_;
  DriverSource drivers_;
  StatePredictor predict_;
  std::optional<ReadCoordinates> read_outside_;
  OutputWriter output_;        // writes what no part delivers
  SolvedState now_, before_;   // the instant solved last, and the one before it
  std::vector<double> start_;  // positions from which a step is tried again
  Failure failure_;
  bool assembled_ = false;  // now_ has positions at its time, whatever is known of rates
  std::unique_ptr<SegmentExecutor> executor_;
  State ended_;  // the instant where the executor ended
  long runs_without_segments_ = 0;
};

}  // namespace desmo
