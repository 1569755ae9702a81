// The verdict of a check, for people.
#pragma once

#include "report/check/check_outcome.h"
#include "report/check/check_record.h"
#include "report/text/document.h"

namespace desmo::report {

/// "PASS", "REGRESSION", ...
const char* verdict_word(Verdict verdict);

/// What was found, candidate by candidate, and what it was found on.
Document verdict_document(const CheckRecord& check, const CheckOutcome& found);

}  // namespace desmo::report
