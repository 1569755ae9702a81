#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/kit/problem.h"
#include "bench/kit/time/timing_windows.h"
#include "bench/kit/verification.h"
#include "cases/mechanism/motion.h"
#include "formulations/formulation.h"
#include "formulations/id.h"

namespace desmo::bench {

/// A formulation, or a peer, under measurement: verified first, and then timed.
class Candidate {
 public:
  enum class Readiness {
    unverified,
    verified,  ///< may be timed
    failed,    ///< cannot be solved, or is wrong; `message` says where
    not_run,   ///< does not exist, or would take too long; `message` says why
  };

  virtual ~Candidate() = default;
  Candidate(const Candidate&) = delete;
  Candidate& operator=(const Candidate&) = delete;

  /// Returns the name of the benchmark: <case>/<coordinates>/<id>, and what else tells it apart.
  virtual std::string name() const = 0;

  /// Builds what is timed and checks it over the whole motion; what goes wrong ends in `message`.
  /// Done once.
  virtual void verify(ReferenceCache& references) = 0;

  /// Measures where the time goes, where that is shown. Needs verify().
  virtual void profile() {}

  /// Runs the whole analysis, as timed. Needs Readiness::verified; a failure turns it into
  /// Readiness::failed.
  virtual Summary analyse() = 0;

  /// Makes what is timed anew, analyses and discards it, on a fresh heap (see on_fresh_heap).
  /// Returns the seconds of the analysis; by the wall clock, which also runs while the system gives
  /// a processor to somebody else, the least of some. Needs Readiness::verified.
  double time_afresh();

  /// Returns "/clock:wall" for one thread by the wall clock, which several are compared with; else
  /// nothing.
  std::string clock_suffix() const {
    return clock == Clock::wall && threads == 1 ? "/clock:wall" : "";
  }

  bool is_verified() const { return state == Readiness::verified; }
  bool is_failed() const { return state == Readiness::failed; }
  bool is_not_run() const { return state == Readiness::not_run; }
  bool is_timed() const { return is_verified() && !seconds.empty(); }

  const TimeGrid grid;
  const int threads;  ///< on which it is solved
  const Clock clock;  ///< of seconds, windows and analysis_seconds
  Readiness state = Readiness::unverified;
  std::string message;          ///< why it failed or was not run
  std::string model;            ///< digest of the model it solves; empty: there is none
  std::string results;          ///< digest of what was compared with the reference, or empty
  std::vector<double> seconds;  ///< samples
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

  /// Ends what is measured, without a time.
  void fail(std::string why) { stop(Readiness::failed, std::move(why)); }
  void leave_out(std::string why) { stop(Readiness::not_run, std::move(why)); }

  /// Ends verify(), once `errors` are known: what solved the whole motion and agrees with its
  /// reference in all `expected_instants` is verified. times: what is allowed, over the usual.
  void conclude(const Summary& summary, const Model& model, std::size_t expected_instants,
                double times = 1);

 private:
  void stop(Readiness reached, std::string why);
};

/// A formulation that solves a problem.
class FormulationCandidate : public Candidate {
 public:
  /// The problem must outlive the candidate.
  FormulationCandidate(const Problem& problem, const Configuration& configuration);
  /// id: as parse_id takes it, which throws for an unusable one. It is the candidate's, whatever
  /// `others`, the settings that it does not name, add to it.
  FormulationCandidate(const Problem& problem, std::string_view id, const Settings& others);

  const Variant& variant() const { return *configuration_.variant; }
  const Settings& settings() const { return configuration_.settings; }
  const Configuration& configuration() const { return configuration_; }

  /// Returns the formulation's id, with its settings, and the clock of one thread where that is the
  /// wall's.
  std::string id() const { return id_ + clock_suffix(); }
  std::string name() const override;

  /// Compares with the problem's reference. The allowed difference grows with a tolerance above the
  /// usual one.
  void verify();
  void verify(ReferenceCache& references) override;
  Summary analyse() override;

  /// Takes a sample of a step's CPU time by a formulation made anew on a fresh heap (see
  /// step_seconds). Nothing unless it is verified.
  void sample_afresh(double duration);
  /// Returns the least of the samples; infinite when there is none.
  double min_seconds() const;
  /// Tells whether it has two samples and its motion takes longer than that, in seconds: no more
  /// are worth it.
  bool is_sampled(double dear_seconds) const {
    return seconds.size() >= 2 && min_seconds() * grid.instants > dear_seconds;
  }

  const int coordinates;
  /// Bytes that the formulation keeps on the heap, with what libraries keep for it: no step touches
  /// more. 0: not known.
  long bytes = 0;

 protected:
  /// Leaves the problem, of a case with so many coordinates, for later (see solve()). asked: is
  /// delivered.
  FormulationCandidate(const TimeGrid& instants, std::string_view case_name, int coordinates,
                       const Configuration& configuration, Clock by, Request asked = {});
  void solve(const Problem& problem) { problem_ = &problem; }

  const Problem& problem() const { return *problem_; }

  /// Solves the whole motion and compares it with a reference, where state is unverified.
  void verify_against(const std::function<std::span<const ReferenceInstant>()>& reference);
  /// Returns what compares what is delivered with the reference; by default, of all coordinates.
  virtual std::unique_ptr<ComparingObserver> comparing(
      std::span<const ReferenceInstant> reference) const;

  /// Makes the formulation, and nothing else of it.
  void build();
  /// Returns the CPU time of a step: the whole motion with its assembly, drivers and delivery into
  /// plain vectors, by the number of instants delivered; over and over until that took
  /// `duration`. Throws std::runtime_error where the motion cannot be solved.
  double step_seconds(double duration);
  void make() override;
  void discard() override { formulation_.reset(); }

  const Request asked_;
  std::unique_ptr<Formulation> formulation_;

 private:
  FormulationCandidate(const Problem& problem, std::string_view id, const Configuration& c);
  std::size_t delivered() const {
    return asked_.coordinates.empty() ? coordinates : asked_.coordinates.size();
  }

  const Problem* problem_ = nullptr;
  const std::string case_name_, id_;
  const Configuration configuration_;
  WindowedDelivery delivery_;
};

/// Allowed difference of the answers of a request from those of the whole mechanism, both converged
/// as far as double precision goes.
inline constexpr double allowed_request_difference = 1e-12;

}  // namespace desmo::bench
