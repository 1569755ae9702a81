#pragma once

#include "formulations/verification/monitor/safe_run.h"

namespace desmo {

/// Ends a run from within its sink.
struct Ended {};

/// Hands on what a watch has judged, and counts it in a summary. Throws Ended, the summary saying
/// why, at an instant that is singular or, being strict, degraded.
class WatchedSink final : public Sink {
 public:
  /// All must outlive it.
  WatchedSink(Watch& watch, const SafetyOptions& options, Sink& next, SafeSummary& summary)
      : watch_(watch), options_(options), next_(next), summary_(summary) {}

  void accept(const Instant& instant) override;
  double largest_residual() const { return largest_residual_; }  ///< of instants handed on

 private:
  void hand_on(const Instant& instant);

  Watch& watch_;
  const SafetyOptions& options_;
  Sink& next_;
  SafeSummary& summary_;
  double largest_residual_ = 0;
};

}  // namespace desmo
