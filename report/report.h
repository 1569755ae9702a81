// The report of a record.
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

}  // namespace desmo::report
