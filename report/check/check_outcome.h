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
  pass = 0,          ///< nothing became slower
  regression = 1,    ///< time or work of some candidate raised an alarm, twice for time
  invalid = 2,       ///< answers are wrong, or head lacks a candidate of the base or baseline
  inconclusive = 3,  ///< times are too noisy, or a second pass is missing
  incomparable = 4,  ///< times or work may not be compared, or nothing was
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
  std::vector<Difference> differences;  ///< why no time is compared; empty when times are
  TimeFindings time;
  WorkFindings work;
};

/// Compares head with base or, where a baseline is given, counts alone with it, an earlier check of
/// one tree. With neither, a right head is CheckVerdict::incomparable.
CheckOutcome compare_sides(const CheckRecord& check, const CheckRecord* baseline = nullptr);

/// Returns the measurements that could still change the verdict: "first CANDIDATE" or "second
/// CANDIDATE", by pass.
std::vector<std::string> pending(const CheckOutcome& found);

/// Returns the verdict with its reasons, a table of times and one of instructions, and a line on
/// what was measured where.
Document verdict_document(const CheckRecord& check, const CheckOutcome& found);

}  // namespace desmo::report
