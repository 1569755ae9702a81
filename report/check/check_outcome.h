// The outcome of a check as a whole.
#pragma once

#include <string>
#include <vector>

#include "report/check/findings.h"
#include "report/text/document.h"

namespace desmo::report {

/// The verdict of a check; its number is the exit code of `desmo_report check`. Where several hold,
/// the gravest counts: invalid, then regression, incomparable, inconclusive, pass.
enum class CheckVerdict {
  pass = 0,          ///< nothing is known to have become slower
  regression = 1,    ///< time or work of some candidate raised an alarm, for time in two passes
  invalid = 2,       ///< answers in head are wrong, or head lacks a candidate of base or baseline
  inconclusive = 3,  ///< times are too noisy, or a second pass is missing
  incomparable = 4,  ///< times or work cannot be compared, or there is nothing to compare
};

/// A candidate whose times are not compared, and the reason: wrong now, wrong before, or new.
struct Excluded {
  std::string candidate, reason;
};

/// All that a check found.
struct CheckOutcome {
  CheckVerdict verdict = CheckVerdict::pass;
  std::vector<Excluded> invalid;        ///< candidates whose answers in head are wrong
  std::vector<std::string> missing;     ///< candidates of the base or baseline that head lacks
  std::vector<Excluded> excluded;       ///< candidates that are new, or were wrong before
  std::vector<Difference> differences;  ///< why times cannot be compared; empty where they can
  TimeFindings time;
  WorkFindings work;
};

/// Compares times and counts of head with those of base. Where a baseline is given (not null),
/// compares counts only, with those of the baseline's head. With neither, the verdict is
/// CheckVerdict::incomparable unless head is wrong.
CheckOutcome compare_sides(const CheckRecord& check, const CheckRecord* baseline = nullptr);

/// Returns the measurements that could still change the verdict: "first CANDIDATE" for more rounds
/// of the first pass, "second CANDIDATE" for rounds, or more rounds, of the second one.
std::vector<std::string> pending(const CheckOutcome& found);

/// Returns the verdict with its reasons, a line on what was measured where, and tables of times and
/// of instructions, where there are any.
Document verdict_document(const CheckRecord& check, const CheckOutcome& found);

}  // namespace desmo::report
