#pragma once

#include <optional>
#include <string>

#include "bench/experiments/extremes/case_run.h"
#include "bench/experiments/extremes/known_case.h"

namespace desmo::extremes {

/// The worst of the errors at one level, with its limits.
struct WorstError {
  double error = 0, floor = 0, allowed = 0;
};

/// The worst of a run's errors, and the first that is wrong, or only more than is allowed.
struct WorstErrors {
  std::optional<PerLevel<WorstError>> worst;
  std::string defect, inexact;
};

/// Returns the worst of a run's errors and the first above what the case's bound makes of
/// floors and a yardstick (see verify). Numbers on another branch do not count.
WorstErrors errors_of(const KnownCase& known, const CaseRun& run, const CaseRun* yardstick);

/// Returns an instant, for people: its time, or which start it is.
std::string instant_text(const KnownCase& known, std::size_t instant);

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
  /// The error of each level whose ratio to the error allowed is the largest, where numbers were
  /// compared; at a level where none is allowed, the largest error.
  std::optional<PerLevel<WorstError>> worst;
};

/// Compares a run with what is known of the case.
///
/// yardstick: the other run that the case's bound names, which this one must not be much worse
/// than: the row's first case in the same formulation, or this case with pivots chosen anew. Null:
/// none.
Verification verify(const KnownCase& known, const CaseRun& run, const CaseRun* yardstick = nullptr);

}  // namespace desmo::extremes
