// The documents of the program: the report of one record, and one record compared with another.
#pragma once

#include <vector>

#include "report/read/record.h"
#include "report/text/document.h"

namespace desmo::report {

/// Returns the page of a record: the sections of what it has measured, and how it was measured.
/// beside: records of other machines. The speed-ups of those that measured the same stand next to
/// the record's own; a section says where there is none. The same records give the same document.
Document make_report(const Record& record, const std::vector<const Record*>& beside = {});

/// Returns the speed-ups of a record next to those of others that measured the same on another
/// machine, each over the usual reference in its own record: of each machine the record that has
/// most in common. Without tables where there is none.
Section machines(const Record& record, const std::vector<const Record*>& others);

/// Says how many times as fast the second record is, for all that both have timed. Of two machines
/// no seconds are shown: see machines(). The records are comparable, or agree in what was solved
/// (statistics/comparability.h).
Document make_comparison(const Record& first, const Record& second);

}  // namespace desmo::report
