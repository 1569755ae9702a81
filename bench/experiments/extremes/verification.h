#pragma once

#include <optional>
#include <string>

#include "bench/experiments/extremes/candidate.h"
#include "bench/experiments/extremes/problem.h"

namespace desmo::extremes {

enum class Outcome {
  converged,       ///< numbers everywhere, without a word
  degraded,        ///< with one: no better than their bounds, or in doubt
  failed,          ///< it says so at one instant at least
  refused,         ///< before anything was solved
  not_applicable,  ///< not tried
};

enum class Verdict {
  as_expected,
  missed,          ///< less than expected: it failed, is less exact, or does not say what it should
  defect,          ///< without a flag, numbers where there is no answer, or wrong by more than the
                   ///< bound and by ten times the tolerance and the floor
  not_applicable,  ///< the reason says why
};

/// The worst of the errors at one level, beside what it was judged by.
struct WorstError {
  double error = 0, floor = 0, allowed = 0;
};

/// A case in one formulation, judged.
struct Judgement {
  Outcome outcome = Outcome::converged;
  Verdict verdict = Verdict::as_expected;
  std::string reason;  ///< when not as expected
  /// Nothing where no number was compared. The worst is the one that is the most of what is
  /// allowed; at a level of which nothing is allowed to be wrong, the largest.
  std::optional<PerLevel<WorstError>> worst;
  long iterations = 0;        ///< of all instants
  long instants = 0;          ///< tried
  long refactorisations = 0;  ///< of pivots kept that had gone bad
};

/// Attempts that others are measured by.
struct Yardsticks {
  const Attempt* first_case = nullptr;  ///< of the row, in the same formulation
  const Attempt* new_pivots = nullptr;  ///< the same case, with pivots chosen anew
};

Judgement judge(const Problem& problem, const Attempt& attempt, const Yardsticks& yardsticks);

}  // namespace desmo::extremes
