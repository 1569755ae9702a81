#pragma once

#include "bench/kit/formulation_candidate.h"
#include "bench/kit/problem.h"
#include "formulations/verification/error.h"

namespace desmo::accuracy {

using bench::Problem;

/// A configuration tried on a problem that has a reference: how wrong it is, and what a step costs.
/// It is verified once its error is known, whatever that is.
class Trial final : public bench::FormulationCandidate {
 public:
  /// The problem must outlive the trial, which is not run where its formulation does not offer the
  /// settings.
  Trial(const Problem& problem, const Configuration& configuration);

  /// Takes a sample of a step's CPU time (see step_seconds). Nothing unless it is verified.
  void time(double duration);

  SolutionError error;  ///< of the outputs asked for

 private:
  Checked check(bench::VerifyingRun& found) override;

  std::unique_ptr<Formulation> formulation_;  // takes all samples; null before verify()
};

/// Returns the largest condition number over the instants of a problem's reference.
double max_condition(const Problem& problem);

}  // namespace desmo::accuracy
