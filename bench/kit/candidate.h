#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/kit/time/timing_windows.h"
#include "bench/kit/verification.h"
#include "cases/mechanism/motion.h"
#include "formulations/formulation.h"

namespace desmo::bench {

/// What is verified and then timed under the name of one benchmark.
class Candidate {
 public:
  enum class State { untouched, verified, failed, not_run };

  virtual ~Candidate() = default;
  Candidate(const Candidate&) = delete;
  Candidate& operator=(const Candidate&) = delete;

  /// Name of the benchmark.
  virtual std::string name() const = 0;

  /// Builds what is timed and checks it over the whole motion; what goes wrong ends in `message`.
  /// Done once.
  virtual void verify(ReferenceCache& references) = 0;

  /// Measures where the time goes, where that is shown. Needs verify().
  virtual void profile() {}

  /// The whole analysis, as timed. Needs State::verified; a failure turns it into State::failed.
  virtual Summary analyse() = 0;

  /// Makes what is timed anew, analyses and discards it, on a fresh heap (see on_fresh_heap).
  /// Returns the seconds of the analysis; by the wall clock, which also runs while the system gives
  /// a processor to somebody else, the least of some. Needs State::verified.
  double time_afresh();

  /// Grows with the time of an analysis, before anything is known of it.
  virtual double expected_work() const = 0;

  /// What stands beside the time on the console.
  virtual std::vector<std::pair<std::string, double>> counters() const = 0;

  /// "/clock:wall" of one thread by the wall clock, which several are compared with; else empty.
  std::string clock_suffix() const {
    return clock == Clock::wall && threads == 1 ? "/clock:wall" : "";
  }

  bool is_failed() const { return state == State::failed; }
  bool is_not_run() const { return state == State::not_run; }
  bool is_timed() const { return state == State::verified && !seconds.empty(); }

  const TimeGrid grid;
  const int threads;  ///< on which it is solved
  const Clock clock;  ///< of seconds, windows and analysis_seconds
  State state = State::untouched;
  std::string message;          ///< why it failed or was not run
  std::string model;            ///< digest of the model it solves; empty: there is none
  std::string results;          ///< digest of what was compared with the reference, or empty
  std::vector<double> seconds;  ///< one for each repetition: time_afresh()
  TimingWindows windows;        ///< of all analyses
  double analysis_seconds = 0;  ///< of the one that was verified
  Errors errors;                ///< from the reference
  double setup_seconds = 0;     ///< CPU: analysis, ordering, allocation
  double iterations_per_step = 0, residual = 0;

 protected:
  /// Several threads are timed by the wall clock, whatever `by` says.
  explicit Candidate(const TimeGrid& instants, int on_threads = 1, Clock by = Clock::cpu)
      : grid(instants),
        threads(on_threads),
        clock(on_threads > 1 ? Clock::wall : by),
        windows(instants.instants, clock) {}

  /// Makes what analyse() runs and assembles it once.
  virtual void make() = 0;
  virtual void discard() = 0;

  /// Solves, where the wall clock measures, until threads and their processors are awake: from
  /// asleep that may take as long as a motion, and longer where the processors are not the system's
  /// own. One thread that several are compared with is treated alike.
  void wake_threads(const std::function<void()>& solve) const;

  void fail(std::string why) { stop(State::failed, std::move(why)); }
  void leave_out(std::string why) { stop(State::not_run, std::move(why)); }

  /// Ends verify(), once `errors` are known: what solved the whole motion and agrees with its
  /// reference in all `expected_instants` is verified.
  void conclude(const Summary& summary, const Model& model, std::size_t expected_instants) {
    if (!summary.ok()) return fail(describe(summary, model));
    if (std::string wrong = verification_failure(errors, expected_instants); !wrong.empty())
      return fail(std::move(wrong));
    iterations_per_step = static_cast<double>(summary.iterations) / summary.instants;
    residual = summary.residual;
    state = State::verified;
  }

 private:
  void stop(State reached, std::string why) {
    state = reached;
    message = std::move(why);
  }
};

}  // namespace desmo::bench
