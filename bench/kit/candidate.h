#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/kit/time/timing_windows.h"
#include "bench/kit/verification.h"
#include "cases/mechanism/motion.h"

namespace desmo::bench {

/// The run that verifies a candidate: what is found and measured.
struct VerifyingRun {
  /// model_digest(), where a part is solved that of the whole model (Problem::whole); empty: not
  /// known.
  std::string model{};
  std::string results{};  ///< Comparison::results; empty: not known
  Differences errors{};   ///< largest differences from the reference, up to `level`
  Level level = Level::acceleration;
  double setup_seconds = 0;     ///< CPU time of analysis, ordering and allocation [s]
  double analysis_seconds = 0;  ///< time of the verified analysis by the candidate's clock [s]
  double iterations_per_step = 0;
  std::optional<double> residual{};  ///< BasicSummary::residual; nothing: not known
  /// Heap memory [bytes] that the formulation keeps, libraries included; a step touches less.
  /// 0: not known.
  long bytes = 0;
};

/// A candidate that will not be timed, and why.
struct Refusal {
  enum class Kind {
    failed,   ///< cannot be solved, or is wrong
    not_run,  ///< does not exist, or would take too long
  };
  Kind kind;
  std::string reason;
};

/// A function that solves the whole motion once, assembly and delivery included. It is called again
/// and again while its time is taken. Throws std::exception where the motion cannot be solved.
using Analysis = std::function<void()>;

/// A formulation, or a peer, that solves a motion. It is verified first. Only then it can be timed;
/// otherwise it has a Refusal:
///
///   unverified ── verify() ──→ verified ── time_afresh(), add_sample() ──→ timed
///        │                        │                                          │
///        │ refuse(), verify()     │ an exception in measure()                │ the same
///        └──────────────────→ refused ←──────────────────────────────────────┘
///
/// Nothing leads out of `refused`.
class Candidate {
 public:
  virtual ~Candidate() = default;
  Candidate(const Candidate&) = delete;
  Candidate& operator=(const Candidate&) = delete;

  /// Returns the name of the benchmark: <case>/<coordinates>/<id>. Derived classes may append more.
  virtual std::string name() const = 0;

  /// Solves the whole motion and compares it with a reference, shared_reference() unless the
  /// candidate brings its own. Does nothing when it was verified or refused before.
  void verify();

  /// Measures the time of each phase, for candidates whose record holds it. Does nothing unless the
  /// candidate is verified.
  virtual void profile() {}

  /// Adds the candidate's entries to the lists of a record (results/record.schema.json); none by
  /// default.
  virtual void add_to(nlohmann::ordered_json& /*lists*/) const {}

  /// Makes an analysis, runs it and discards it, on a fresh heap (see run_on_fresh_heap). Returns
  /// the time of the run [s]. By the wall clock, returns the least of several runs, since other
  /// processes may interrupt one. Returns nothing unless the candidate is verified and all runs go
  /// well.
  std::optional<double> time_afresh();
  /// Adds a time that was measured by clock(). Does nothing unless it is verified.
  void add_sample(double seconds);

  const std::vector<double>& seconds() const { return seconds_; }  ///< samples of the time [s]
  const TimingWindows& windows() const { return windows_; }  ///< timing windows of all analyses
  bool is_verified() const { return is_verified_; }
  bool is_failed() const { return is_refused(Refusal::Kind::failed); }
  bool is_not_run() const { return is_refused(Refusal::Kind::not_run); }
  bool is_timed() const { return !seconds_.empty(); }
  /// Returns why it was refused; empty when it was not.
  std::string message() const { return refusal_ ? refusal_->reason : ""; }
  /// Returns what verify() found, as far as it came.
  const VerifyingRun& verifying_run() const { return verifying_run_; }

  const TimeGrid& grid() const { return grid_; }
  int threads() const { return threads_; }  ///< number of threads on which it is solved
  Clock clock() const { return clock_; }    ///< clock of samples, windows and verified analysis

 protected:
  /// Several threads are timed by the wall clock, whatever `by` says.
  explicit Candidate(const TimeGrid& instants, int on_threads = 1, Clock by = Clock::cpu)
      : grid_(instants),
        threads_(on_threads),
        clock_(on_threads > 1 ? Clock::wall : by),
        windows_(instants.instants, clock_) {}

  /// The result of a check; nothing: all is right.
  using Checked = std::optional<Refusal>;

  /// Solves the whole motion and compares it with a reference. Fills in what it finds. verify()
  /// turns an exception into a Refusal of kind `failed`.
  virtual Checked check(VerifyingRun& found) = 0;

  /// Makes the analysis that is timed, with the mechanism assembled once. windows: receives the
  /// times of the analysis, and outlives it. Called by time_afresh() only.
  virtual Analysis make_analysis(TimingWindows& windows) const = 0;

  /// Runs a measurement if the candidate is verified. An exception of it becomes a refusal.
  void measure(const std::function<void()>& measurement);
  static Refusal failed(std::string why) { return {Refusal::Kind::failed, std::move(why)}; }
  static Refusal not_run(std::string why) { return {Refusal::Kind::not_run, std::move(why)}; }
  /// Refuses the candidate for good, and drops all samples.
  void refuse(Refusal why);

 private:
  bool is_refused(Refusal::Kind kind) const { return refusal_ && refusal_->kind == kind; }

  const TimeGrid grid_;
  const int threads_;
  const Clock clock_;
  bool is_verified_ = false;
  std::optional<Refusal> refusal_;
  std::vector<double> seconds_;
  TimingWindows windows_;
  VerifyingRun verifying_run_;
};

}  // namespace desmo::bench
