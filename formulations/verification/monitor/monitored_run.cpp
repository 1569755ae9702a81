#include "formulations/verification/monitor/monitored_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "formulations/prediction/driver_source.h"
#include "formulations/verification/monitor/branch_monitor.h"

namespace desmo {

namespace {

/// To which the ends of an interval that cannot be assembled are found, s.
constexpr double bracket = 1e-9;

AccuracyMonitorOptions monitor_options(const MonitoredRunOptions& options, const Formulation& f) {
  AccuracyMonitorOptions result = options;
  const auto reuses = [](const DefinedPart& part) { return part.solver->reuses_pivots(); };
  result.reuses_pivots |= std::ranges::any_of(f.parts(), reuses);
  if (options.strict) result.every = 1;
  return result;
}

/// One run, in spans between the intervals that cannot be assembled. As an observer of the
/// formulation it hands on what the monitors let pass, and stops the run otherwise.
class Run final : Observer {
 public:
  Run(Formulation& formulation, const TimeGrid& grid, const Request& request, Observer& observer,
      const MonitoredRunOptions& options)
      : formulation_(formulation),
        grid_(grid),
        request_(request),
        options_(options),
        accuracy_(formulation.model(), grid, monitor_options(options, formulation)),
        branch_(formulation.model(), options.levels, options.tolerance),
        output_(request, formulation.model().coordinates()),
        next_(observer) {}

  MonitoredSummary operator()() {
    const Summary ran = formulation_.run(grid_, request_, *this);
    if (!ran.stopped) static_cast<Summary&>(summary_) = ran;  // or the observer has said why
    tried_ = static_cast<int>(summary_.instants);             // all before it were handed on
    if (!summary_.ok() && grid_.time(tried_) < summary_.time) {
      summary_.status = Status::converged;  // a stride was too long: in steps from there
      go_on(tried_, From::last);
    }
    measure_assembly_error();
    while (!summary_.ok() && options_.past_failures) {
      const int again = pass_gap();
      go_on(again, From::estimate);
      measure_assembly_error();
    }
    summary_.condition = accuracy_.condition();
    summary_.bound = accuracy_.bound();
    summary_.assessed = accuracy_.assessed();
    summary_.corrected = accuracy_.corrected();
    summary_.degraded = accuracy_.degraded();
    summary_.first_degraded = accuracy_.first_degraded();
    return summary_;
  }

 private:
  Flow observe(const Instant& instant) noexcept override {
    const MonitoredInstant m = accuracy_.examine(instant);
    summary_.time = instant.time;
    if (m.assessment.singular) {
      // What was interpolated is nowhere near a solution.
      summary_.status = instant.interpolated ? Status::not_converged : Status::singular;
      summary_.group = m.assessment.group;
      summary_.constraint = -1;
      summary_.residual = instant.interpolated ? INFINITY : instant.residual;
      return Flow::stop;
    }
    if (m.crossing && !summary_.crossing) summary_.crossing = m.crossing;
    summary_.refused = options_.strict && (m.degraded || m.crossing);
    summary_.violated = branch_.violated(m.instant);
    if (summary_.refused || summary_.violated >= 0) return Flow::stop;
    summary_.updates += instant.updates;
    summary_.residual = max_residual_ = std::max(max_residual_, instant.residual);
    if (options_.monitored) options_.monitored(m);
    const Flow flow = output_.hand_over(m.instant, next_);
    ++summary_.instants;
    summary_.stopped = flow == Flow::stop;
    return flow;
  }

  /// Whether the run ended between two instants that could be solved.
  bool was_interpolated() const { return summary_.residual == INFINITY; }

  void measure_assembly_error() {
    if (summary_.status != Status::not_converged) return;
    const Model& m = formulation_.model();
    State state;
    state.q.assign(formulation_.q().begin(), formulation_.q().end());
    state.q.insert(state.q.end(), m.fixed_values.begin(), m.fixed_values.end());
    state.qd = state.qdd = state.q;
    write_drivers(m, summary_.time, state);
    summary_.assembly_error = find_assembly_error(m, state.q, {.tolerance = options_.tolerance});
    // Continued from the row before, in ever shorter steps, and stuck all the same.
    if (!summary_.assembly_error && was_interpolated()) summary_.status = Status::singular;
  }

  /// From the instant that failed to the first that can be assembled again.
  int pass_gap() {
    const double end = grid_.time(grid_.instants - 1);
    Gap gap{summary_.time, end, false, summary_, summary_.assembly_error};
    if (tried_ > 0) {
      const double good = grid_.time(tried_ - 1);
      if (was_interpolated()) formulation_.assemble(good);  // it has been beyond
      gap.from = last_solved(good, gap.from);
    }
    int again = tried_ + 1;
    const auto assembled = [&] { return formulation_.assemble(grid_.time(again)).ok(); };
    while (again < grid_.instants && !assembled()) ++again;
    gap.ends = again < grid_.instants;
    if (gap.ends) gap.to = last_solved(grid_.time(again), grid_.time(again - 1));
    summary_.gaps.push_back(gap);
    summary_.status = Status::converged;
    summary_.group = summary_.constraint = -1;
    summary_.residual = max_residual_;
    summary_.assembly_error.reset();
    accuracy_.resume();
    return again;
  }

  /// The last time that can be solved on the way from one where the formulation is to one where
  /// it cannot.
  double last_solved(double good, double bad) {
    while (std::abs(bad - good) > bracket) {
      const double middle = good + (bad - good) / 2;
      if (middle == good || middle == bad) break;
      (formulation_.step(middle, Level::position).ok() ? good : bad) = middle;
    }
    return good;
  }

  enum class From { estimate, last };
  void go_on(int first, From from) {
    for (tried_ = first; tried_ < grid_.instants; ++tried_) {
      const double t = summary_.time = grid_.time(tried_);
      const Summary s = tried_ == first && from == From::estimate
                            ? formulation_.assemble(t, request_.level)
                            : formulation_.step(t, request_.level);
      summary_.iterations += s.iterations;
      if (!s.ok()) {
        summary_.status = s.status;
        summary_.group = s.group;
        summary_.constraint = s.constraint;
        summary_.residual = s.residual;
        return;
      }
      const std::span<const double> none;
      const Instant instant{tried_,
                            t,
                            formulation_.q(),
                            request_.level >= Level::velocity ? formulation_.qd() : none,
                            request_.level >= Level::acceleration ? formulation_.qdd() : none,
                            s.updates,
                            s.residual};
      if (observe(instant) == Flow::stop) return;
    }
  }

  Formulation& formulation_;
  const TimeGrid grid_;
  const Request request_;
  const MonitoredRunOptions options_;
  MonitoredSummary summary_{};
  AccuracyMonitor accuracy_;
  BranchMonitor branch_;
  const OutputWriter output_;
  Observer& next_;
  double max_residual_ = 0;  // of the instants handed on
  int tried_ = 0;            // the instant tried last
};

}  // namespace

MonitoredSummary run_monitored(Formulation& formulation, const TimeGrid& grid,
                               const Request& request, Observer& observer,
                               const MonitoredRunOptions& options) {
  return Run(formulation, grid, request, observer, options)();
}

std::string describe_accuracy(double condition, const PerLevel<double>& bound, Level level) {
  const auto number = [](double x) {
    char text[16];
    std::snprintf(text, sizeof text, "%.1e", x);
    return std::string(text);
  };
  std::string result =
      "condition " + number(condition) + ", errors up to " + number(bound.position);
  if (level >= Level::velocity) result += ", " + number(bound.velocity) + " in velocity";
  if (level >= Level::acceleration)
    result += ", " + number(bound.acceleration) + " in acceleration";
  return result;
}

}  // namespace desmo
