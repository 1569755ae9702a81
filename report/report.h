// The whole report of one record.
#pragma once

#include "report/document.h"
#include "report/record.h"

namespace desmo::report {

/// The paper's tables for every sparse family, what follows from them, everything else that was
/// recorded, and how it was measured. The same record gives the same document.
Document make_report(const Record& record);

}  // namespace desmo::report
