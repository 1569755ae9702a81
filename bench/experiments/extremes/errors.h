#pragma once

#include <cstdio>
#include <optional>
#include <string>

#include "bench/experiments/extremes/case_run.h"
#include "bench/experiments/extremes/known_case.h"

namespace desmo::extremes {

/// The worst of the errors at one level, with its limits.
struct WorstError {
  double error = 0, floor = 0, allowed = 0;
};

/// Runs that others are measured by.
struct Yardsticks {
  const CaseRun* first_case = nullptr;  ///< of the row, in the same formulation
  const CaseRun* new_pivots = nullptr;  ///< the same case, with pivots chosen anew
};

/// The worst of a run's errors, and the first that is wrong, or only more than is allowed.
struct WorstErrors {
  std::optional<PerLevel<WorstError>> worst;
  std::string defect, inexact;
};

/// Returns the worst of a run's errors and the first above what the case's bound makes of
/// floors and yardsticks. Numbers on another branch do not count.
WorstErrors errors_of(const KnownCase& known, const CaseRun& run, const Yardsticks& yardsticks);

/// Returns an instant, for people: its time, or which start it is.
std::string at(const KnownCase& known, std::size_t instant);

inline std::string formatted(const char* format, auto... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace desmo::extremes
