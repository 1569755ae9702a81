#pragma once

#include <optional>
#include <string>

#include "bench/experiments/extremes/case_run.h"
#include "bench/experiments/extremes/known_case.h"

namespace desmo::extremes {

/// The worst of the errors at one level, its floor (Answers::floor), and the error allowed. All are
/// relative.
struct WorstError {
  double error = 0, floor = 0, allowed = 0;
};

/// The errors of a run.
struct WorstErrors {
  std::optional<PerLevel<WorstError>> worst;  ///< as Verification::worst
  /// First error that nothing excuses, and first other error above the allowed one, in words;
  /// empty: none.
  std::string defect, inexact;
};

/// Returns the worst of a run's errors, and the first ones above the error that the case's bound
/// allows. yardstick: as in verify(). Numbers flagged as on another branch do not count.
WorstErrors errors_of(const KnownCase& known, const CaseRun& run, const CaseRun* yardstick);

/// Returns an instant, for people: "at t = 0.3 s", or "from start 7".
std::string instant_text(const KnownCase& known, std::size_t instant);

enum class ExtremeVerdict {
  as_expected,
  missed,  ///< less than expected: it failed, is less exact, or does not say what it should
  defect,  ///< unflagged numbers where there is no answer, or an error that nothing excuses: it is
           ///< above the bound, the radius stated with it, and ten times tolerance and floor
  not_applicable,  ///< not tried, or nothing is known to compare with
};

/// The verification of a case in one formulation.
struct Verification {
  CaseOutcome outcome = CaseOutcome::converged;
  ExtremeVerdict verdict = ExtremeVerdict::as_expected;
  std::string reason;  ///< why the verdict is not as_expected; else empty
  /// For each level the error with the largest ratio to the error allowed; where none is allowed,
  /// the largest error. Nothing: no numbers were compared.
  std::optional<PerLevel<WorstError>> worst;
};

/// Compares a run with what is known of the case.
///
/// yardstick: the other run with which the case's bound compares this one: the row's first case in
/// the same formulation, or this case with pivots chosen anew. Null: none.
Verification verify(const KnownCase& known, const CaseRun& run, const CaseRun* yardstick = nullptr);

}  // namespace desmo::extremes
