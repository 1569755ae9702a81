// The parts of the report, one .cpp each: pure functions of the record and of the paper's tables.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/read/record.h"
#include "report/statistics/variants.h"
#include "report/text/document.h"

namespace desmo::report {

/// The answer: three fixed sentences with numbers, the data of figure 6, and the best formulations.
/// Puts no number into a sentence where fewer than three repetitions were measured.
Section answer(const Record& record);

/// Table 1 of the paper for one sparse family: CPU seconds of every analysis, ours above the
/// paper's, which is marked in or out of our interval. Its sizes are the paper's, the largest
/// four-bar and whatever else was recorded.
Table cpu_times(const Record& record, std::string_view family);

/// Table 2 of the paper for one sparse family, which stands in the sparse columns and in the
/// global reference alike: speed-up and improvement, ours above the paper's.
Table speed_ups(const Record& record, std::string_view family);

/// How the paper's own solver is named beside the families.
inline constexpr const char* paper_solver = "MA27 (the paper)";

/// The data of figure 5, CPU time over coordinates: a row for each sparse solver and size.
Table figure_of_times(const Record& record);

/// The data of figure 6, mean speed-up over the global formulation: a row for each variant.
Table figure_of_speed_ups(const Record& record);

/// What the paper prints of a variant in a row of its table 1 or 2 ("114" ... "mean"), with the
/// quantities of ours: {seconds, median, repetitions}, {speed_up, low, high, percent}.
Entry published_seconds_entry(const std::string& row, const Variant& variant);
Entry published_speed_up_entry(const std::string& row, const Variant& variant);

/// The same formulations over every global reference that has a time, at the largest of the paper's
/// sizes recorded; nothing when there is no such reference or formulation.
std::optional<Table> references(const Record& record, const std::string& case_name);

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

/// What must not be concluded from the record.
Section limitations(const Record& record);

/// What settings and generated code gain over the paper's: a table for each case that was solved
/// with settings. Without tables when none was.
Section beyond(const Record& record);

/// Makes the tables of what several threads gain over one, by the wall clock: a table for each case
/// that was solved on several.
std::vector<Table> threads(const Record& record);

/// Makes the tables of what peers take next to the formulations that start from the same guess: a
/// table for each case, and one of what they needed to be set up. Without tables when the record
/// has no peers.
Section peers(const Record& record);

/// One line for every candidate, request or peer that failed its verification; empty when none did.
std::vector<std::string> failures(const Record& record);

}  // namespace desmo::report
