// The tables and sections of the report, one topic a .cpp: pure functions of the record and of the
// paper's tables. Their words stand in text/texts.txt.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/read/history.h"
#include "report/read/record.h"
#include "report/statistics/curves.h"
#include "report/statistics/measurements.h"
#include "report/statistics/variants.h"
#include "report/text/document.h"

namespace desmo::report {

// ---- paper ----

/// Says the answer: three fixed sentences with numbers, the data of figure 6, and the best
/// formulations. Puts no number into a sentence where fewer than three repetitions were measured.
Section answer(const Record& record);

/// Shows tables 1 and 2 of the paper for each sparse family recorded.
Section paper_tables(const Record& record);

/// Returns the data of figure 5, CPU time over coordinates: a row for each sparse solver and size.
Table figure_of_times(const Record& record);

/// Returns the data of figure 6, mean speed-up over the global formulation: a row for each variant.
Table figure_of_speed_ups(const Record& record);

/// Shows what several threads gain over one, by the wall clock: a table for each case.
Section threads(const Record& record);

/// Shows what it costs to solve only what is asked: a table for each case and size.
Section requests(const Record& record);

/// Shows what it costs to check a run: a step, and the start. No table where none was checked.
Section checks(const Record& record);

/// Shows what peers take next to the formulations that start from the same guess: a table for each
/// case.
Section peers(const Record& record);

/// Shows everything that was recorded of each case at each size, fastest first.
Section every_formulation(const Record& record);

/// Shows where the time of a step goes.
Table time_split(const Record& record);

// ---- accuracy ----

/// Returns all of the accuracy experiment in sections, the front first. The record has points.
std::vector<Section> accuracy_sections(const Record& record);

/// Returns the data of the work–precision figure of a motion: every configuration solved or failed,
/// fastest first.
Table work_precision(const Record& record, const SeriesKey& series);

/// Shows table 2 with other steps, tolerances and guesses.
Table sensitivity(const Record& record);

// ---- size, modelling, instructions, extremes ----

/// Returns all about time against size, the front first. The record has sizes.
std::vector<Section> size_sections(const Record& record);

/// Shows the paper's comparison in each kind of coordinates, the front first. The record has
/// `modelled`.
std::vector<Section> modelling_sections(const Record& record);

/// Shows instructions of a step, and how many times those of the usual reference, the front first.
/// The record has `instructions`.
std::vector<Section> instructions_sections(const Record& record);

/// Shows which formulation does what where most go wrong, the front first. The record has extremes.
std::vector<Section> extremes_sections(const Record& record);

// ---- about other commits, and about the record ----

/// Draws the history of instructions a step, and lists the commits in which a candidate moved.
Section history_section(const History& history);

/// Shows when, on what and how it was measured.
Table provenance(const Record& record);

/// Says what must not be concluded from the record.
Section limitations(const Record& record);

/// Returns a line for every candidate, request or peer that failed its verification.
std::vector<std::string> failures(const Record& record);

}  // namespace desmo::report
