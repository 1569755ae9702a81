// The parts of the report, one .cpp each: pure functions of the record and of the paper's tables.
#pragma once

#include <string_view>
#include <vector>

#include "report/document.h"
#include "report/record.h"

namespace desmo::report {

/// Table 1 of the paper for one sparse family: CPU seconds of every analysis, ours above the
/// paper's. Its sizes are the paper's, the largest four-bar and whatever else was recorded.
Table cpu_times(const Record& record, std::string_view family);

/// Table 2 of the paper for one sparse family, which stands in the sparse columns and in the
/// global reference alike: speed-up and improvement, ours above the paper's.
Table speed_ups(const Record& record, std::string_view family);

/// What the choice of the sparse solver does to the paper's conclusions: sentences that follow
/// from the numbers, whatever they are, and the verdicts they rest on.
Section conclusion(const Record& record);

/// Log-log slope of CPU time over coordinates, the paper's values and every family.
Table scaling(const Record& record);

/// Everything that was recorded of one case at one size, fastest first.
Table every_formulation(const Record& record, std::string_view case_name, std::int64_t coordinates);

/// Where the time of a step goes.
Table time_split(const Record& record);

/// When, on what and how it was measured.
Table provenance(const Record& record);

/// How each partition cuts the unknowns, what the equations know beyond the bodies, and what that
/// is worth. Without tables when the record has no structure.
Section partitions(const Record& record);

/// What it costs to solve only what is asked, one table for each case and size. Without tables when
/// the record has no requests.
Section requests(const Record& record);

/// One line for every cell or request that failed its verification; empty when none did.
std::vector<std::string> failures(const Record& record);

}  // namespace desmo::report
