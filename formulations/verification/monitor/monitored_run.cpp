#include "formulations/verification/monitor/monitored_run.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "formulations/base/output_writer.h"
#include "formulations/base/part.h"
#include "formulations/stepping/formulation_core.h"
#include "formulations/stepping/strided_steps.h"
#include "formulations/verification/monitor/accuracy_monitor.h"
#include "formulations/verification/monitor/branch_monitor.h"
#include "formulations/verification/monitor/gap_search.h"

namespace desmo {

namespace {

AccuracyMonitorOptions monitor_options(const MonitoredRunOptions& options,
                                       std::span<const Level> levels, std::span<const Level> asked,
                                       const Formulation& f, unsigned without) {
  AccuracyMonitorOptions result{.tolerance = f.settings().tolerance,
                                .levels = levels,
                                .asked = asked,
                                .assesses_all = options.strict || options.assesses_all,
                                .without = without};
  for (const DefinedPart& part : parts_of(f))
    if (part.solver->pivots().may_spoil_rates()) {
      result.reuses_pivots = true;
      if (!core_of(f).needs_known_motion())  // else others do the work
        result.parts.push_back(part.solver.get());
    }
  return result;
}

/// Velocities are solved in any case: from positions alone nobody can tell which branch they are
/// on.
Request with_velocities(Request request) {
  request.level = std::max(request.level, Level::velocity);
  return request;
}

std::vector<Level> with_velocities(std::vector<Level> levels) {
  for (Level& level : levels) level = std::max(level, Level::velocity);
  return levels;
}

/// Returns the level to which each coordinate is asked for.
std::vector<Level> asked_levels(const Model& m, Level level, std::span<const Level> given) {
  if (!given.empty() && std::ssize(given) != m.coordinates())
    throw std::invalid_argument("a monitored run is not given one level for each coordinate");
  std::vector<Level> levels(given.begin(), given.end());
  levels.resize(m.coordinates(), level);
  return levels;
}

/// One run, in spans between the intervals that cannot be assembled. As an observer of the
/// formulation it hands on what the monitors let pass, and stops the run otherwise.
class Run final : Observer {
  using From = StridedSteps::From;

  /// What becomes of the run after an instant.
  enum class Then {
    go_on,           ///< the formulation is where the instant is
    return_to_last,  ///< it is elsewhere, and has to go there first
    halve_stride,    ///< the instant was interpolated, and is not good enough
  };

 public:
  Run(Formulation& formulation, const TimeGrid& grid, const Request& request, Observer& observer,
      const MonitoredRunOptions& options, unsigned without)
      : formulation_(formulation),
        grid_(grid),
        level_(request.level),
        asked_(asked_levels(formulation.model(), request.level, options.levels)),
        levels_(with_velocities(asked_)),
        request_(with_velocities(request)),
        options_(options),
        without_(without),
        branch_(formulation.model(), levels_, formulation.settings().tolerance),
        steps_(formulation, grid, request_.level, *this),
        output_(request, formulation.model().coordinates()),
        next_(observer) {
    if (!options.levels.empty() && levels_ != asked_) formulation.solve_only(levels_);
    if (has(Monitor::correction)) corrections_.emplace(parts_of(formulation_));
    begin_monitoring();
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  MonitoredSummary operator()() {
    const Summary ran = formulation_.run(grid_, request_, *this);
    if (!ran.stopped) static_cast<BasicSummary&>(summary_) = ran;  // or the observer has said why
    summary_.iterations = ran.iterations;
    tried_ = static_cast<int>(summary_.instants);  // all before it were handed on
    // Assembled in one go, but elsewhere.
    if (tried_ == 0 && summary_.violated >= 0 && has(Monitor::continuation)) {
      summary_ = {};
      begin_monitoring();
      is_continued_ = true;
      then_ = Then::return_to_last;
    }
    if (then_ == Then::halve_stride) steps_.halve();
    const bool failed = !summary_.ok() && (tried_ > 0 || has(Monitor::continuation));
    if (failed || then_ != Then::go_on) {
      summary_.status = Status::solved;
      then_ = Then::return_to_last;
      go_on(tried_, From::last);
    }
    measure_assembly_error();
    for (; !summary_.ok() && options_.past_failures; measure_assembly_error())
      go_on(pass_gap(), From::estimate);
    summary_.condition = accuracy_->condition();
    summary_.bound = accuracy_->bound();
    summary_.scales = accuracy_->scales();
    summary_.assessed = accuracy_->assessed();
    summary_.corrected = accuracy_->corrected();
    summary_.degraded = accuracy_->degraded();
    summary_.first_degraded = accuracy_->first_degraded();
    summary_.shortest_stride = steps_.shortest();
    return summary_;
  }

 private:
  void begin_monitoring() {
    accuracy_.emplace(formulation_.model(), grid_,
                      monitor_options(options_, levels_, asked_, formulation_, without_));
  }
  bool has(Monitor monitor) const { return !(without_ & static_cast<unsigned>(monitor)); }

  Flow observe(const Instant& instant) noexcept override {
    MonitoredInstant m = accuracy_->examine(instant);
    if (m.too_coarse) {
      tried_ = instant.index;
      then_ = Then::halve_stride;
      return Flow::stop;
    }
    summary_.time = instant.time;
    if (m.assessment.singular)
      if (const auto passed = accuracy_->pass(instant)) m = *passed;
    then_ = m.solved_anew ? Then::return_to_last : Then::go_on;
    return m.assessment.singular ? stop_at(m) : hand_on(std::move(m));
  }

  Flow stop_at(const MonitoredInstant& m) {
    summary_.status = Status::singular;
    summary_.group = m.assessment.group;
    summary_.constraint = no_position;
    summary_.residual = m.instant.residual;
    blame_rounding(m.assessment);
    return Flow::stop;
  }

  void blame_rounding(const Assessment& a) {
    if (a.limit != Limit::singular_position && a.limit != Limit::rounding) summary_.limit = a.limit;
  }

  Flow hand_on(MonitoredInstant&& m) {
    if (has(Monitor::branch)) summary_.violated = branch_.violated(m.instant, m.angles_follow);
    if (summary_.violated >= 0 && has(Monitor::repair))
      if (const auto again = accuracy_->solve_again(m.instant)) {
        m = *again;
        then_ = Then::return_to_last;
        summary_.violated = branch_.violated(m.instant);
      }
    const Instant& instant = m.instant;
    if (summary_.violated >= 0) {
      accuracy_->withdraw(instant);
      if (m.degraded) blame_rounding(m.assessment);
    }
    summary_.refused = options_.strict && (m.degraded || m.crossing);
    if (is_continued_ && summary_.instants == 0 && !m.crossing)
      m.crossing = {instant.time, instant.time, m.assessment.group,
                    SingularityCrossing::Kind::not_declared};
    if (m.crossing && !summary_.crossing) summary_.crossing = m.crossing;
    if (summary_.refused || summary_.violated >= 0) return Flow::stop;
    summary_.updates += instant.updates;
    summary_.residual = max_residual_ = std::max(max_residual_, instant.residual);
    if (options_.monitored) options_.monitored(m);
    Instant asked = options_.refined ? options_.refined(instant) : instant;
    if (level_ < Level::velocity) asked.qd = {};
    const Flow flow = output_.hand_over(asked, next_);
    ++summary_.instants;
    summary_.stopped = flow == Flow::stop;
    return then_ == Then::go_on ? flow : Flow::stop;
  }

  /// Takes the formulation to where the last instant handed on is, or beyond the singular position
  /// that it lies in. Before the first instant it goes there from the nominal position.
  void return_to_last() {
    const Model& m = formulation_.model();
    const auto [q, time] = accuracy_->last();
    std::vector<double> state(m.estimate);
    if (!q.empty()) state.assign(q.begin(), q.end());
    state.insert(state.end(), m.fixed_values.begin(), m.fixed_values.end());
    steps_.restart();
    core_of(formulation_).start_at(state, q.empty() ? grid_.time(tried_) : time);
  }

  void measure_assembly_error() {
    if (summary_.status == Status::not_converged)
      summary_.assembly_error = assembly_error_at(formulation_, summary_.time);
  }

  /// From the instant that failed to the first that can be assembled again.
  int pass_gap() {
    const auto [gap, again] = find_gap(formulation_, grid_, tried_, summary_);
    summary_.gaps.push_back(gap);
    summary_.status = Status::solved;
    summary_.group = summary_.constraint = no_position;
    summary_.residual = max_residual_;
    summary_.assembly_error.reset();
    summary_.limit.reset();
    accuracy_->resume();
    return again;
  }

  void go_on(int first, From from) {
    steps_.restart();
    for (tried_ = first; tried_ < grid_.instants;) {
      if (then_ != Then::go_on && from == From::last) return_to_last();
      then_ = Then::go_on;
      const auto [s, instant] = steps_.solve(tried_, std::exchange(from, From::last));
      summary_.time = instant.time;
      summary_.iterations += s.iterations;
      if (s.ok()) steps_.hand_on(instant);
      if (then_ == Then::halve_stride || (!s.ok() && instant.index > tried_)) {
        steps_.halve();
        then_ = Then::return_to_last;
        continue;
      }
      if (!s.ok() && !solved_by_monitor(instant)) {
        summary_.status = s.status;
        summary_.group = s.group;
        summary_.constraint = s.constraint;
        summary_.residual = s.residual;
        return;
      }
      if (!summary_.ok() || summary_.refused || summary_.violated >= 0 || summary_.stopped) return;
      tried_ = instant.index + 1;
    }
  }

  /// Solves an instant where the formulation could not, from the one before it.
  bool solved_by_monitor(const Instant& instant) {
    auto m = accuracy_->solve(instant);
    if (!m) return false;
    then_ = Then::return_to_last;
    hand_on(std::move(*m));
    return true;
  }

  Formulation& formulation_;
  std::optional<OneMoreCorrection> corrections_;
  const TimeGrid grid_;
  const Level level_;                        // asked for
  const std::vector<Level> asked_, levels_;  // of each coordinate: asked for, solved
  const Request request_;
  const MonitoredRunOptions options_;
  const unsigned without_;  // monitors left out
  /// The summary so far.
  struct Progress : MonitoredSummary {
    bool ok() const { return status == Status::solved; }  // the last instant tried
  };
  Progress summary_{};
  std::optional<AccuracyMonitor> accuracy_;
  BranchMonitor branch_;
  StridedSteps steps_;
  const OutputWriter output_;
  Observer& next_;
  double max_residual_ = 0;    // of the instants handed on
  bool is_continued_ = false;  // the first instant, since it was assembled on another branch
  Then then_ = Then::go_on;
  int tried_ = 0;  // the instant tried last
};

}  // namespace

MonitoredSummary run_monitored_without(unsigned without, Formulation& formulation,
                                       const TimeGrid& grid, const Request& request,
                                       Observer& observer, const MonitoredRunOptions& options) {
  if (!request.coordinates.empty())
    throw std::invalid_argument("a monitored run is asked for some coordinates; it needs all");
  return Run(formulation, grid, request, observer, options, without)();
}

MonitoredSummary run_monitored(Formulation& formulation, const TimeGrid& grid,
                               const Request& request, Observer& observer,
                               const MonitoredRunOptions& options) {
  return run_monitored_without(0, formulation, grid, request, observer, options);
}

}  // namespace desmo
