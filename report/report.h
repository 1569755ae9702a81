// The whole report of one record, or of some that belong together.
#pragma once

#include <vector>

#include "report/read/record.h"
#include "report/text/document.h"

namespace desmo::report {

/// The paper's tables for every sparse family, what follows from them, everything else that was
/// recorded, and how it was measured. The same record gives the same document.
Document make_report(const Record& record);

/// One page of several records, at least one, each section from the first that has what it needs.
/// Their times may stand on one page (comparability.h).
Document make_report(const std::vector<Record>& records);

}  // namespace desmo::report
