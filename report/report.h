// The documents of the program: the report of one record, or of some that belong together, and one
// record compared with another.
#pragma once

#include <vector>

#include "report/read/record.h"
#include "report/text/document.h"

namespace desmo::report {

/// Returns a page of several records, at least one, each section from the first that has what it
/// needs, and how they were measured. Their times may stand on one page
/// (statistics/comparability.h). beside: records of which speed-ups stand next to these, where they
/// are of another machine and of the same work; a section says where there is none. The same
/// records give the same document.
Document make_report(const std::vector<const Record*>& records,
                     const std::vector<const Record*>& beside = {});
Document make_report(const Record& record);

/// Returns the speed-ups of a record next to those of others that measured the same on another
/// machine, each over the usual reference in its own record: of each machine the record that has
/// most in common. Without tables where there is none.
Section machines(const Record& record, const std::vector<const Record*>& others);

/// Says how many times as fast the second record is, for all that both have timed. Of two machines
/// no seconds are shown: see machines(). The records are comparable, or agree in what was solved
/// (statistics/comparability.h).
Document make_comparison(const Record& first, const Record& second);

}  // namespace desmo::report
