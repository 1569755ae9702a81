// One run beside another.
#pragma once

#include "report/document.h"
#include "report/record.h"

namespace desmo::report {

/// How many times as fast the second record is, for everything timed or to be timed in either. The
/// records are comparable (report/comparability.h).
Document make_comparison(const Record& first, const Record& second);

}  // namespace desmo::report
