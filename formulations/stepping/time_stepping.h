#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "formulations/formulation.h"
#include "formulations/prediction/driver_source.h"
#include "formulations/prediction/state_predictor.h"
#include "formulations/stepping/part_sequence.h"

namespace desmo {

/// The paper's Fig. 2a: instant after instant, drivers, prediction, and the parts in order.
class TimeStepping final : public Formulation {
 public:
  /// settings: those that the parts were made with. The model outlives this.
  TimeStepping(const Model& model, std::vector<DefinedPart> parts, const Settings& settings);

  Summary assemble(double t, Level level) override;
  Summary step(double t, Level level) override;
  bool is_live() const override { return true; }
  Summary step(const LiveRow& row, Level level, int max_sub_steps) override;
  void return_to(std::span<const double> q, double t) override;
  Summary run(const TimeGrid& grid, const Request& request, Observer& observer) override;
  bool start_at(std::span<const double> q, double t) override;
  std::optional<Summary> run_on(const TimeGrid& grid, const Request& request,
                                Observer& observer) override;
  void solve_only(std::span<const Level> needed) override;
  const std::vector<DefinedPart>& parts() const override { return sequence_.parts(); }
  const State& state() const override { return state_; }

  /// Takes over an instant that was solved otherwise, up to `level`: steps go on from there.
  void take(const State& solved, double t, Level level);

 private:
  static constexpr int unlimited = std::numeric_limits<int>::max();

  /// The level to which an instant was solved; nothing: it is unknown.
  struct Solved {
    double time = 0;  // s
    std::optional<Level> level{};
  };

  /// The coordinates of each instant that others than parts read.
  struct Wanted {
    std::vector<int> coordinates;  // empty: all …
    bool lent;                     // … in memory that the observer lends, or in the state
  };

  void prepare();
  void forget();
  void want(const Request& request, bool lent = false);
  Summary take_steps(const TimeGrid& grid, const Request& request, Observer& observer);
  Summary solve_at(double t, Level level);
  Summary solve_or_sub_step(double t, Level level);
  Summary sub_step(double from, double t, Level level, const Summary& at_once);
  Summary assemble_alone(double t, Level level);
  void find_culprit_of(const PartSequence::Result& result, Summary& summary);
  Flow deliver(int index, double t, const Summary& step, Level level, Observer& observer);

  PartSequence sequence_;
  DriverSource drivers_;
  StatePredictor predict_;
  std::optional<Wanted> wanted_;
  OutputWriter output_;  // of what no part delivers
  State state_;
  State before_;               // the instant before that of state_
  Solved now_, then_;          // what state_ and before_ hold
  std::vector<double> start_;  // positions from which a step is tried again
  int max_sub_steps_ = unlimited;
  bool assembled_ = false;
};

}  // namespace desmo
