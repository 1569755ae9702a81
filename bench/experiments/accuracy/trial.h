#pragma once

#include "bench/kit/formulation_candidate.h"
#include "bench/kit/problem.h"
#include "formulations/verification/error.h"

namespace desmo::accuracy {

using bench::Problem;

/// A configuration tried on a problem that has a reference: its error, and the time of a step. It
/// counts as verified when the motion was solved, whatever its error.
class Trial final : public bench::FormulationCandidate {
 public:
  /// The problem must outlive the trial. Refuses the trial (Refusal::Kind::not_run) where its
  /// formulation does not offer the settings.
  Trial(const Problem& problem, const Configuration& configuration);

  /// Takes a sample of a step's time by clock(), over at least `duration` [s] (see step_seconds).
  /// Does nothing unless it is verified.
  void time(double duration);

  SolutionError error;  ///< errors of the plan's outputs, or of everything where it has none

 private:
  Checked check(bench::VerifyingRun& found) override;

  std::unique_ptr<Formulation> formulation_;  // takes all samples; null before verify()
};

/// Returns the largest condition number over the instants of a problem's reference.
double max_condition(const Problem& problem);

}  // namespace desmo::accuracy
