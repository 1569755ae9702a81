#pragma once

#include <optional>
#include <string>

#include "bench/experiments/extremes/errors.h"

namespace desmo::extremes {

enum class ExtremeVerdict {
  as_expected,
  missed,          ///< less than expected: it failed, is less exact, or does not say what it should
  defect,          ///< without a flag, numbers where there is no answer, or wrong by more than the
                   ///< bound and by ten times the tolerance and the floor
  not_applicable,  ///< the reason says why
};

/// The verification of a case in one formulation.
struct Verification {
  CaseOutcome outcome = CaseOutcome::converged;
  ExtremeVerdict verdict = ExtremeVerdict::as_expected;
  std::string reason;  ///< when not as expected
  /// The errors that are the most of what is allowed, where numbers were compared; at a level
  /// where no error is allowed, the largest.
  std::optional<PerLevel<WorstError>> worst;
  long iterations = 0;        ///< of all instants
  long instants = 0;          ///< tried
  long refactorisations = 0;  ///< of pivots kept that had gone bad
};

/// Compares a run with what is known of the case.
Verification verify(const KnownCase& known, const CaseRun& run, const Yardsticks& yardsticks);

}  // namespace desmo::extremes
