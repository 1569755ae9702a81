#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "formulations/verification/assessment/assessor.h"
#include "formulations/verification/assessment/backward_error.h"
#include "formulations/verification/assessment/degradations.h"
#include "formulations/verification/assessment/expectation.h"
#include "formulations/verification/assessment/limits.h"
#include "formulations/verification/assessment/measured_error.h"
#include "formulations/verification/monitor/accuracy_monitor.h"
#include "formulations/verification/monitor/branch_signs.h"
#include "formulations/verification/monitor/condition_monitor.h"
#include "formulations/verification/monitor/continuity.h"
#include "formulations/verification/monitor/running_scales.h"
#include "formulations/verification/monitor/sensitivity_monitor.h"

namespace desmo {

/// The monitors of one motion, what they know of its instants, and the counts. accuracy_monitor.cpp
/// has the steps that an instant goes through. accuracy_assessment.cpp decides whether it is
/// assessed, and assesses it. accuracy_repair.cpp solves instants again.
/// accuracy_equations.cpp chooses other equations.
struct AccuracyMonitor::State {
  /// The statement about an instant that is not assessed, and whether it holds.
  struct Statement {
    Assessment assessment;
    bool holds;
  };
  /// Bounds of rates above which it cannot be told whether they lead on.
  static constexpr double unusable_rate = 1e-3;

  State(const Model& m, const TimeGrid& grid, const AccuracyMonitorOptions& o);
  /// Makes a state that goes on from another one with other equations. Null: those given.
  State(const State& before, std::unique_ptr<const Model> other);

  bool has(Monitor monitor) const { return !(options.without & static_cast<unsigned>(monitor)); }
  Norm norm() const { return has(Monitor::lengths) ? Norm::of_blocks : Norm::of_whole; }
  Continuity::Means means() { return {assessor, scales.current(), weights, signs}; }

  MonitoredInstant examine(const Instant& instant);
  bool is_poor(const MonitoredInstant& j) const;
  std::unique_ptr<State> with_equations_at(std::span<const double> q, const Instant& like);
  std::unique_ptr<State> with_equations_given(const Instant& like) const;
  bool begin_at_last(const Instant& like);
  std::vector<double> expected_positions(const Instant& instant);
  std::optional<Continuity::Jump> find_jump(MonitoredInstant& j, bool from_noise);
  void deliver(const MonitoredInstant& j, bool is_assessed);
  void add(const Degradation& d, bool is_degraded);
  std::optional<MonitoredInstant> solve(const Instant& instant);
  std::optional<Instant> solve_from_last(const Instant& instant);
  std::optional<Instant> solve_alone(const Instant& instant);
  void take_back(const Instant& instant);
  void declare(MonitoredInstant& j);
  std::optional<Instant> solve_declared(const Instant& instant);
  bool solve_singular(MonitoredInstant& j, const Expectation::Signals& signals);
  void solve_crossed(MonitoredInstant& j, const Expectation::Signals& signals);
  std::optional<Instant> solve_anew(const Instant& instant);
  Instant with_known_rates(const Instant& instant);
  Level known_rates();
  std::optional<MonitoredInstant> pass(const Instant& singular);
  PerLevel<double> difference(const Instant& a, const Instant& b) const;

  std::optional<StepMeasures> measure_step(const Instant& instant);
  Expectation::Signals signals_of(const Instant& instant, const std::optional<StepMeasures>& step);
  ConditionMonitor::Ways ways(const Instant& instant, const std::optional<StepMeasures>& step);
  bool is_due(const Expectation::Signals& signals) const;
  Statement state(const Instant& instant, const Assessment& expected);
  bool has_bad_pivots() const;
  bool rates_are_known() const {
    return !exceeds(last.bound, {unusable_rate, unusable_rate, unusable_rate});
  }
  bool is_in_doubt(const Instant& instant, const Expectation::Signals& signals,
                   const std::optional<StepMeasures>& step);
  double min_excursion(double growth) const;

  void assess(MonitoredInstant& j, const Expectation::Signals& signals, bool in_doubt);
  bool is_too_coarse(const Instant& instant, const Assessment& a, bool in_doubt);
  void measure(Assessment& a, const Instant& instant);
  bool improve(MonitoredInstant& j);
  bool take_if_better(Instant& instant, const Instant& better);
  Instant kept(const Instant& instant);
  double worst_share(const Assessment& a) const;
  std::optional<SingularityCrossing> crossing(const Instant& instant);
  void look_at_scales(const Instant& instant);
  void follow_scales(const Scales& before);

  const Model& given;
  const std::unique_ptr<const Model> chosen{};  // null: the equations given
  const Model& model;                           // either of them
  const AccuracyMonitorOptions options;
  const bool has_others;  // equations that were left out
  const Limits limits;
  Assessor assessor;
  std::vector<Level> asked;  // of each coordinate
  MeasuredError measured;
  RunningScales scales;
  SensitivityMonitor sensitivity;
  ConditionMonitor conditioning;
  Continuity continuity;
  BackwardError backward_error;
  Expectation expectation{};
  BranchSigns signs;
  std::vector<EntityId> entity;     // of each coordinate
  Eigen::ArrayXd weights;           // the largest so far: near a dead point they say little
  double max_weight_ratio = 1;      // the largest ratio of these to those of the last assessment
  ConditionMonitor::Ways speeds{};  // of the last instant, by the same measures; none: infinity
  Start beyond{};                   // a singular position, where the last instant lies in one
  desmo::State improved{};  // values of the instant examined, where they are not those given

  Assessment last{};  // the latest one
  double last_time = 0;
  bool started = false, degraded = false;
  bool after_gap = false, is_doubted = false;
  bool no_better = false;        // equations than those kept, where these are poor
  bool is_declared = false;      // the first instant: the nominal position leads there,
  std::vector<double> declared;  // to these positions
  int since = 0;                 // instants since the last assessment
  double condition = 0;
  PerLevel<double> worst{}, worst_before{};  // the largest bounds; without the last instant's
  Degradations degradations;
  long assessed = 0, corrected = 0;
};

}  // namespace desmo
