#include "formulations/safety/safe_run.h"

#include <algorithm>
#include <cstdio>

namespace desmo {

namespace {

/// Ends a run from within its sink.
struct Ended {};

/// Hands on what a watch has judged.
class WatchedSink final : public Sink {
 public:
  WatchedSink(Watch& watch, bool strict, Sink& next, SafeSummary& summary)
      : watch_(watch), strict_(strict), next_(next), summary_(summary) {}

  void accept(const Instant& instant) override {
    if (instant.interpolated) return hand_on(instant);
    const Watch::Judgement j = watch_.judge(instant);
    summary_.time = instant.time;
    if (j.assessment.singular) {
      summary_.status = Status::singular;
      summary_.group = j.assessment.group;
      summary_.residual = instant.residual;
      throw Ended{};
    }
    if (j.crossing && !summary_.crossing) summary_.crossing = j.crossing;
    if (j.degraded && summary_.degraded++ == 0)
      summary_.first_degraded = {instant.index, instant.time, j.assessment};
    summary_.refused = strict_ && (j.degraded || j.crossing);
    if (summary_.refused) throw Ended{};
    summary_.updates += instant.updates;
    summary_.residual = std::max(summary_.residual, instant.residual);
    hand_on(j.instant);
  }

 private:
  void hand_on(const Instant& instant) {
    next_.accept(instant);
    ++summary_.instants;
  }

  Watch& watch_;
  bool strict_;
  Sink& next_;
  SafeSummary& summary_;
};

}  // namespace

SafeSummary run_safely(Formulation& formulation, const TimeGrid& grid, const Request& request,
                       Sink& sink, const SafetyOptions& options) {
  Watch watch(formulation.mechanism(), grid, options);
  SafeSummary summary;
  WatchedSink watched(watch, options.strict, sink, summary);
  try {
    static_cast<Summary&>(summary) = formulation.run(grid, request, watched);
  } catch (const Ended&) {
  }
  summary.condition = watch.condition();
  summary.bound = watch.bound();
  summary.assessed = watch.assessed();
  summary.corrected = watch.corrected();
  return summary;
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
