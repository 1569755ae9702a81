// The outcome of a check as a whole.
#pragma once

#include <string>
#include <vector>

#include "report/check/findings.h"
#include "report/text/document.h"

namespace desmo::report {

/// Exit codes of `desmo_report check`.
enum class CheckVerdict {
  pass = 0,
  regression = 1,
  invalid = 2,
  inconclusive = 3,
  incomparable = 4
};

/// A candidate that is not judged, and why.
struct Excluded {
  std::string candidate, reason;
};

struct CheckOutcome {
  CheckVerdict verdict = CheckVerdict::pass;
  std::vector<Excluded> invalid;        ///< candidates whose answers in head are wrong
  std::vector<std::string> missing;     ///< candidates of the baseline that head lacks
  std::vector<Excluded> excluded;       ///< candidates without anything to compare with
  std::vector<Difference> differences;  ///< why no time is compared; empty when times are
  TimeFindings time;
  WorkFindings work;
};

/// Compares head with base, or with head of a stored baseline, which is a check of one tree, too. A
/// check of head alone without a baseline is CheckVerdict::incomparable.
CheckOutcome compare_sides(const CheckRecord& check, const CheckRecord* baseline = nullptr);

/// A measurement that a final verdict still needs.
struct Pending {
  std::string pass;  ///< "first" or "second"
  std::string candidate;
};
std::vector<Pending> pending(const CheckOutcome& found);

/// Returns the verdict with its reasons, a table of times and one of instructions, and a line on
/// what was measured where.
Document verdict_document(const CheckRecord& check, const CheckOutcome& found);

}  // namespace desmo::report
