// Parts that figures share: each fills a design of report/figures/*.template.json with the numbers
// of a table.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "cases/io/new_files.h"
#include "report/read/record.h"
#include "report/text/document.h"

namespace desmo::report {

/// Leaves in a specification's parameter `shown` and in the scales of colour and shape (of these
/// encodings, which have either) only what was measured: it keeps its colour and shape. What the
/// design does not know is a grey cross.
void keep_measured(nlohmann::ordered_json& spec,
                   const std::vector<nlohmann::ordered_json*>& encodings,
                   const std::set<std::string>& measured);

/// Returns a specification with data, title and subtitle of the table, whose name it has.
NewFile filled_figure(const Table& table, nlohmann::ordered_json spec, nlohmann::ordered_json data);

/// Draws what a coordinate costs a step over the memory of the formulation, a panel for each case,
/// with the caches of the machine: growth.vl.json.
NewFile growth_figure(const Record& record);

/// Draws a mark for each configuration solved, the Pareto front, the floor of the reference, the
/// limits predicted from conditioning, and below a rail for each reason of a failure:
/// work_precision_<case>.vl.json. The case has a main series (statistics/selection.h).
NewFile work_precision_figure(const Record& record, const std::string& case_name);

/// figure5.vl.json, CPU time over coordinates, and figure6.vl.json, mean speed-up: the paper's own
/// values beside every sparse family. What failed or is missing has null where a number would be.
/// The design is in report/figures/*.template.json; data, title and subtitle are those of the
/// tables of the figures (tables/tables.h). These of a record with candidates; of one with points
/// figures/work_precision.h for each case, of one with growth figures/growth.h.
std::vector<NewFile> figures(const Record& record);

}  // namespace desmo::report
