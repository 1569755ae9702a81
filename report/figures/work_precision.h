// The work–precision diagram of a case as a Vega-Lite specification with its data inline.
#pragma once

#include <string>

#include "report/formats/formats.h"
#include "report/read/record.h"

namespace desmo::report {

/// work_precision_<case>.vl.json: a mark for each configuration solved, the Pareto front, the floor
/// of the reference, the limits predicted from conditioning, and below a rail for each reason of a
/// failure. The design is in report/figures/work_precision.template.json, the numbers are those of
/// the table of the same name (tables/precision.h). The case has a main series
/// (precision/selection.h).
Rendered work_precision_figure(const Record& record, const std::string& case_name);

}  // namespace desmo::report
