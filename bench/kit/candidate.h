#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/kit/time/timing_windows.h"
#include "bench/kit/verification.h"
#include "cases/mechanism/motion.h"

namespace desmo::bench {

/// The run that verifies a candidate: what is found and measured.
struct VerifyingRun {
  std::string model{};    ///< digest of the model, of a request's the whole; may be empty
  std::string results{};  ///< digest of what was compared with the reference, or empty
  Differences errors{};   ///< from the reference, up to `level`
  Level level = Level::acceleration;
  double setup_seconds = 0;     ///< CPU: analysis, ordering, allocation
  double analysis_seconds = 0;  ///< of the analysis that was verified, by the candidate's clock
  double iterations_per_step = 0;
  std::optional<double> residual{};  ///< nothing: not known
  /// Heap memory [bytes] that the formulation keeps, libraries included; a step touches less.
  /// 0: not known.
  long bytes = 0;
};

/// Why a candidate is not run: it does not exist here, or would take too long.
class NotRun : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An analysis: solves the whole motion, assembly and delivery included, again and again while its
/// time is taken. Throws std::exception where that fails.
using Analysis = std::function<void()>;

/// A formulation, or a peer, that solves a motion. Only what has passed its verification is timed:
///
///   unverified ── verify() ──→ verified ── time_afresh(), add_sample() ──→ timed
///        │                        │                                         │
///        │ leave_out(), verify()  │ an exception while its time is taken    │ the same
///        └────────────────→ failed, or not run ←────────────────────────────┘
///
/// Nothing leads out of `failed` and `not_run`.
class Candidate {
 public:
  virtual ~Candidate() = default;
  Candidate(const Candidate&) = delete;
  Candidate& operator=(const Candidate&) = delete;

  /// Returns the name of the benchmark: <case>/<coordinates>/<id>, and what else tells it apart.
  virtual std::string name() const = 0;

  /// Solves the whole motion and compares it with a reference, shared_reference() unless the
  /// candidate brings its own. Does nothing when it was verified or refused before.
  void verify();

  /// Measures where the time goes, for candidates whose split is shown. Does nothing unless it is
  /// verified.
  virtual void profile() {}

  /// Adds its entries to the lists of a record (results/record.schema.json); none by default.
  virtual void add_to(nlohmann::ordered_json& lists) const;

  /// Makes an analysis, runs it, and discards it, on a fresh heap (see on_fresh_heap). Returns the
  /// seconds of its run; by the wall clock, the least of several runs: others may interrupt one.
  /// Returns nothing unless the candidate is verified. A run that fails makes it a failed one.
  std::optional<double> time_afresh();

  /// Adds a time [s] that was measured by the candidate's clock. Does nothing unless it is
  /// verified.
  void add_sample(double seconds);

  const std::vector<double>& seconds() const { return seconds_; }  ///< samples
  const TimingWindows& windows() const { return windows_; }  ///< timing windows of all analyses

  bool is_verified() const { return state_ == State::verified; }
  bool is_failed() const { return state_ == State::failed; }
  bool is_not_run() const { return state_ == State::not_run; }
  bool is_timed() const { return is_verified() && !seconds_.empty(); }

  /// Returns why it failed or is not run; empty otherwise.
  const std::string& message() const { return message_; }
  /// Returns what its verification found before it ended or failed.
  const VerifyingRun& verifying_run() const { return verifying_run_; }

  const TimeGrid& grid() const { return grid_; }
  int threads() const { return threads_; }  ///< on which it is solved
  Clock clock() const { return clock_; }    ///< of seconds, windows and the verified analysis

 protected:
  /// Several threads are timed by the wall clock, whatever `by` says.
  explicit Candidate(const TimeGrid& instants, int on_threads = 1, Clock by = Clock::cpu)
      : grid_(instants),
        threads_(on_threads),
        clock_(on_threads > 1 ? Clock::wall : by),
        windows_(grid_.instants, clock_) {}

  /// Solves the whole motion and compares it with a reference. Fills in what it finds. Throws
  /// NotRun where it is not to be run; what else it throws is a failure.
  virtual void check(VerifyingRun& found) = 0;

  /// Makes the analysis that is timed, and assembles it once. windows: receives its times; outlives
  /// it.
  virtual Analysis make_analysis(TimingWindows& windows) const = 0;

  /// Does some work if the candidate is verified. An exception of it is the candidate's failure.
  void measure(const std::function<void()>& work);
  /// Says that it is not run, and why.
  void leave_out(std::string reason) { end(State::not_run, std::move(reason)); }

 private:
  enum class State { unverified, verified, failed, not_run };

  void end(State state, std::string why);

  const TimeGrid grid_;
  const int threads_;
  const Clock clock_;
  State state_ = State::unverified;
  std::string message_;
  VerifyingRun verifying_run_;
  std::vector<double> seconds_;
  TimingWindows windows_;
};

}  // namespace desmo::bench
