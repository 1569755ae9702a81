// The part of the report about the table of extremes: pure functions of the record.
#pragma once

#include "report/read/record.h"
#include "report/text/document.h"

namespace desmo::report {

/// Everything below, with the number of defects in a sentence. The record has extremes.
Section extremes(const Record& record);

/// Formulations × rows: whether all cases are as expected, or how many are not, and the worst error
/// over its floor.
Table extremes_by_formulation(const Record& record);

/// What is extreme in each row, what is expected, and how many results are what.
Table extreme_rows(const Record& record);

/// Every case: how many formulations do as expected, and the first that does not, with its reason.
Table extreme_cases(const Record& record);

}  // namespace desmo::report
