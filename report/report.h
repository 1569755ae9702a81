// The documents of the program: the report of one record, or of some that belong together, and one
// record compared with another.
#pragma once

#include <vector>

#include "report/read/record.h"
#include "report/text/document.h"

namespace desmo::report {

/// The paper's tables for every sparse family, what follows from them, everything else that was
/// recorded, and how it was measured. The same record gives the same document.
Document make_report(const Record& record);

/// Returns a page of several records, at least one, each section from the first that has what it
/// needs. Their times may stand on one page (statistics/comparability.h).
Document make_report(const std::vector<Record>& records);

/// Says how many times as fast the second record is, for all that both have timed. Of two machines
/// no seconds are shown: their speed-ups stand side by side, each over the usual reference in its
/// own record. The records are comparable, or agree in what was solved
/// (statistics/comparability.h).
Document make_comparison(const Record& first, const Record& second);

}  // namespace desmo::report
