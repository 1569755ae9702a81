#pragma once

#include <utility>

#include "formulations/verification/monitor/safe_run.h"

namespace desmo {

/// Hands on what a watch has judged, and counts it in a summary. Stops the run, the summary saying
/// why, at an instant that is singular or, being strict, degraded.
class MonitoredObserver final : public Observer {
 public:
  /// All must outlive it.
  MonitoredObserver(Watch& watch, const SafetyOptions& options, OutputWriter output, Observer& next,
                    SafeSummary& summary)
      : watch_(watch),
        options_(options),
        output_(std::move(output)),
        next_(next),
        summary_(summary) {}

  Flow observe(const Instant& instant) noexcept override;
  double max_residual() const { return max_residual_; }  ///< of instants handed on

 private:
  Watch& watch_;
  const SafetyOptions& options_;
  const OutputWriter output_;
  Observer& next_;
  SafeSummary& summary_;
  double max_residual_ = 0;
};

}  // namespace desmo
