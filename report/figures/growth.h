// The figure of growth as a Vega-Lite specification with its data inline.
#pragma once

#include "report/formats/formats.h"
#include "report/read/record.h"

namespace desmo::report {

/// growth.vl.json: what a coordinate costs a step over the memory of the formulation, a panel for
/// each case, with the caches of the machine. The design is in report/figures/growth.template.json,
/// the numbers are those of the table of the same name (tables/sizes.h).
Rendered growth_figure(const Record& record);

}  // namespace desmo::report
