// What stands in front of the sections of an experiment: a fixed sentence and a few rows of its
// tables. Pure functions of the record.
#pragma once

#include "report/read/record.h"
#include "report/text/document.h"

namespace desmo::report {

/// The record has points.
Section accuracy_in_short(const Record& record);

/// The record has tuning.
Section tuning_in_short(const Record& record);

/// The record has growth or break_even.
Section size_in_short(const Record& record);

/// The record has instructions.
Section instructions_in_short(const Record& record);

/// The record has extremes.
Section extremes_in_short(const Record& record);

}  // namespace desmo::report
