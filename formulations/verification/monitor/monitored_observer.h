#pragma once

#include "formulations/verification/monitor/safe_run.h"

namespace desmo {

/// Ends a run from within its observer.
struct Ended {};

/// Hands on what a watch has judged, and counts it in a summary. Throws Ended, the summary saying
/// why, at an instant that is singular or, being strict, degraded.
class MonitoredObserver final : public Observer {
 public:
  /// All must outlive it.
  MonitoredObserver(Watch& watch, const SafetyOptions& options, Observer& next,
                    SafeSummary& summary)
      : watch_(watch), options_(options), next_(next), summary_(summary) {}

  void observe(const Instant& instant) override;
  double max_residual() const { return max_residual_; }  ///< of instants handed on

 private:
  void hand_on(const Instant& instant);

  Watch& watch_;
  const SafetyOptions& options_;
  Observer& next_;
  SafeSummary& summary_;
  double max_residual_ = 0;
};

}  // namespace desmo
