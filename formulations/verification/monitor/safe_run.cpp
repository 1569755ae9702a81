#include "formulations/verification/monitor/safe_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "formulations/prediction/driver_source.h"
#include "formulations/verification/monitor/monitored_observer.h"

namespace desmo {

namespace {

/// To which the ends of an interval that cannot be assembled are found, s.
constexpr double bracket = 1e-9;

/// What a watch has to know of a formulation.
Watch::Options with_pivots(Watch::Options options, const Formulation& f) {
  const auto reuses = [](const DefinedPart& part) { return part.solver->reuses_pivots(); };
  options.reuses_pivots |= std::ranges::any_of(f.parts(), reuses);
  return options;
}

/// One run, stretch by stretch between the intervals that cannot be assembled.
class Run {
 public:
  Run(Formulation& formulation, const TimeGrid& grid, const Request& request, Observer& observer,
      const SafetyOptions& options)
      : formulation_(formulation),
        grid_(grid),
        request_(request),
        options_(options),
        watch_(formulation.model(), grid, with_pivots(options, formulation)),
        observer_(watch_, options_, {request, formulation.model().coordinates()}, observer,
                  summary_) {}

  SafeSummary operator()() {
    const Summary ran = formulation_.run(grid_, request_, observer_);
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
    summary_.condition = watch_.condition();
    summary_.bound = watch_.bound();
    summary_.assessed = watch_.assessed();
    summary_.corrected = watch_.corrected();
    summary_.degraded = watch_.degraded();
    summary_.first_degraded = watch_.first_degraded();
    return summary_;
  }

 private:
  /// Whether the run ended between two instants that could be solved.
  bool was_interpolated() const { return summary_.residual == INFINITY; }

  void measure_assembly_error() {
    if (summary_.status != Status::not_converged) return;
    const Model& m = formulation_.model();
    State state;
    state.q.assign(formulation_.q().begin(), formulation_.q().end());
    state.q.insert(state.q.end(), m.fixed_values.begin(), m.fixed_values.end());
    state.qd = state.qdd = state.q;
    drive(m, summary_.time, state);
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
    summary_.residual = observer_.max_residual();
    summary_.assembly_error.reset();
    watch_.resume();
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
      if (observer_.observe(instant) == Flow::stop) return;
    }
  }

  Formulation& formulation_;
  const TimeGrid grid_;
  const Request request_;
  const SafetyOptions options_;
  SafeSummary summary_{};
  Watch watch_;
  MonitoredObserver observer_;
  int tried_ = 0;  // the instant tried last
};

}  // namespace

SafeSummary run_safely(Formulation& formulation, const TimeGrid& grid, const Request& request,
                       Observer& observer, const SafetyOptions& options) {
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
