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

/// The run that verifies a candidate: what is found and measured.
struct VerifyingRun {
  std::string model{};          ///< digest of the model that was solved; empty: there is none
  std::string results{};        ///< digest of what was compared with the reference, or empty
  Differences errors{};         ///< from the reference
  double setup_seconds = 0;     ///< CPU: analysis, ordering, allocation
  double analysis_seconds = 0;  ///< of the analysis that was verified, by the candidate's clock
  double iterations_per_step = 0, residual = 0;
  /// Bytes that a formulation keeps on the heap, with what libraries keep for it: no step touches
  /// more. 0: not known.
  long bytes = 0;
};

/// A formulation, or a peer, under measurement: verified first, and then timed. Only what is
/// verified has samples, and what is not says why.
class Candidate {
 public:
  enum class Readiness {
    unverified,
    verified,  ///< may be timed
    failed,    ///< cannot be solved, or is wrong; message() says where
    not_run,   ///< does not exist, or would take too long; message() says why
  };

  virtual ~Candidate() = default;
  Candidate(const Candidate&) = delete;
  Candidate& operator=(const Candidate&) = delete;

  /// Returns the name of the benchmark: <case>/<coordinates>/<id>, and what else tells it apart.
  virtual std::string name() const = 0;

  /// Builds what is timed and checks it over the whole motion; what goes wrong ends in message().
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

  /// Adds a sample [s]. Throws std::logic_error unless it is verified.
  void add_sample(double seconds);

  /// Returns "/clock:wall" for one thread by the wall clock, which several are compared with; else
  /// nothing.
  std::string clock_suffix() const {
    return clock == Clock::wall && threads == 1 ? "/clock:wall" : "";
  }

  Readiness readiness() const { return readiness_; }
  bool is_verified() const { return readiness_ == Readiness::verified; }
  bool is_failed() const { return readiness_ == Readiness::failed; }
  bool is_not_run() const { return readiness_ == Readiness::not_run; }
  bool is_timed() const { return is_verified() && !seconds_.empty(); }

  /// Returns why it failed or was not run.
  const std::string& message() const { return message_; }
  /// Returns what verify() found, as far as it came.
  const VerifyingRun& verifying_run() const { return verifying_run_; }
  const std::vector<double>& seconds() const { return seconds_; }  ///< samples
  const TimingWindows& windows() const { return windows_; }        ///< of all analyses

  const TimeGrid grid;
  const int threads;  ///< on which it is solved
  const Clock clock;  ///< of seconds, windows and the verified analysis

 protected:
  /// Several threads are timed by the wall clock, whatever `by` says.
  explicit Candidate(const TimeGrid& instants, int on_threads = 1, Clock by = Clock::cpu)
      : grid(instants),
        threads(on_threads),
        clock(on_threads > 1 ? Clock::wall : by),
        windows_(instants.instants, clock) {}

  /// Makes what analyse() runs and assembles it once.
  virtual void make() = 0;
  virtual void discard() = 0;

  /// Verifies it by a check, once. check: fills in what it finds, and returns what is wrong; empty:
  /// nothing. It may call leave_out(). What it throws is wrong, too.
  void verify_by(const std::function<std::string(VerifyingRun&)>& check);

  /// Runs a measurement of what is verified; nothing otherwise. What it throws makes it fail.
  void measure(const std::function<void()>& measurement);

  /// Solves, where the wall clock measures, until threads and their processors are awake: from
  /// asleep that may take as long as a motion, and longer where the processors are not the system's
  /// own. One thread that several are compared with is treated alike.
  void wake_threads(const std::function<void()>& solve) const;

  /// Ends what is measured, without a time.
  void fail(std::string why) { stop(Readiness::failed, std::move(why)); }
  void leave_out(std::string why) { stop(Readiness::not_run, std::move(why)); }

  TimingWindows& measured_windows() { return windows_; }

 private:
  void stop(Readiness reached, std::string why);

  Readiness readiness_ = Readiness::unverified;
  std::string message_;
  VerifyingRun verifying_run_;
  std::vector<double> seconds_;
  TimingWindows windows_;
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
    return seconds().size() >= 2 && min_seconds() * grid.instants > dear_seconds;
  }

  const int coordinates;

 protected:
  /// A problem that is made when it is first needed: those of all candidates would be too many.
  using ProblemSource = std::function<std::shared_ptr<const Problem>()>;

  /// case_name, coordinates: of the problem. asked: is delivered.
  FormulationCandidate(const TimeGrid& instants, std::string_view case_name, int coordinates,
                       const Configuration& configuration, Clock by, ProblemSource problem,
                       Request asked = {});

  /// Returns the problem. Throws what its source throws.
  const Problem& problem() const;

  using ReferenceSource = std::function<std::span<const ReferenceInstant>()>;
  /// Solves the whole motion and compares it with a reference. Returns what is wrong, as
  /// verify_by() takes it.
  std::string compare_with(const ReferenceSource& reference, VerifyingRun& found);
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

  const ProblemSource source_;
  mutable std::shared_ptr<const Problem> problem_;  // null: not yet made
  const std::string case_name_, id_;
  const Configuration configuration_;
  WindowedDelivery delivery_;
};

/// Allowed difference of the answers of a request from those of the whole mechanism, both solved
/// as far as double precision goes.
inline constexpr double allowed_request_difference = 1e-12;

}  // namespace desmo::bench
