#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/kit/candidate.h"
#include "bench/kit/problem.h"
#include "formulations/formulation.h"
#include "formulations/id.h"

namespace desmo::bench {

/// A formulation that solves a problem.
class FormulationCandidate : public Candidate {
 public:
  /// The problem must outlive the candidate.
  FormulationCandidate(const Problem& problem, const Configuration& configuration);
  /// id: becomes the candidate's id; parse_id() reads it and throws for an unusable one. others:
  /// settings that the id does not name.
  FormulationCandidate(const Problem& problem, std::string_view id, const Settings& others);

  const Problem& problem() const { return problem_; }
  const Variant& variant() const { return *configuration_.variant; }
  const Settings& settings() const { return configuration_.settings; }
  const Configuration& configuration() const { return configuration_; }

  /// Returns the formulation's id with its settings. "/clock:wall" follows where the wall clock
  /// measures one thread, for comparison with several.
  std::string id() const;
  std::string name() const override;
  const std::string& case_name() const;  ///< <case> in its name
  /// Returns the number of coordinates of Problem::whole or, without it, of those delivered.
  int coordinates() const;

  /// Takes a sample of a step's time by a formulation made anew on a fresh heap (see step_seconds).
  /// duration: least time of the sample [s]. Does nothing unless the candidate is verified.
  void sample_afresh(double duration);
  /// Returns the least of the samples; infinite when there is none.
  double min_seconds() const;
  /// Returns whether the candidate has two samples or more and needs no others, since its motion
  /// takes longer than long_motion_seconds [s].
  bool has_enough_samples(double long_motion_seconds) const;

 protected:
  /// id: the candidate's id, without settings that all candidates share. configuration: variant and
  /// all settings, shared ones included.
  FormulationCandidate(const Problem& problem, std::string_view id,
                       const Configuration& configuration, Clock by = Clock::cpu);

  /// Compares with the problem's own reference or, where it has none, with shared_reference(). The
  /// allowed differences are max(1, Problem::tolerance / usual tolerance) times allowed_difference.
  Checked check(VerifyingRun& found) override;

  /// Runs the whole motion, by default without checks. This run is verified and timed.
  virtual Summary run(Formulation& formulation, Observer& observer) const;

  /// Makes a formulation of the problem's plan. Throws what desmo::make_formulation() throws.
  std::unique_ptr<Formulation> make_formulation() const;
  /// Runs the whole motion again and again until `duration` [s] has passed. Returns the time [s] by
  /// clock(), divided by the number of instants delivered. The time includes assembly, drivers and
  /// delivery into plain vectors. Throws std::runtime_error where the motion cannot be solved.
  double step_seconds(Formulation& formulation, double duration) const;

  const Request request_;

 private:
  Analysis make_analysis(TimingWindows& windows) const override;
  std::unique_ptr<Formulation> make_assembled() const;
  std::vector<Compared> compared(std::span<const ReferenceInstant> reference) const;
  std::size_t delivered() const;  ///< number of coordinates that are delivered

  const Problem& problem_;
  const std::string id_;
  const Configuration configuration_;
};

}  // namespace desmo::bench
