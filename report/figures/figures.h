// The report's figures as Vega-Lite specifications with their data inline.
#pragma once

#include <vector>

#include "cases/io/new_files.h"
#include "report/read/record.h"

namespace desmo::report {

/// figure5.vl.json, CPU time over coordinates, and figure6.vl.json, mean speed-up: the paper's own
/// values beside every sparse family. What failed or is missing has null where a number would be.
/// The design is in report/figures/*.template.json; data, title and subtitle are those of the
/// tables of the figures (tables/tables.h). These of a record with candidates; of one with points
/// figures/work_precision.h for each case, of one with growth figures/growth.h.
std::vector<NewFile> figures(const Record& record);

}  // namespace desmo::report
