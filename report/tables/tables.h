// The tables and sections of the report, each topic in its own .cpp. They are pure functions of the
// record and of the paper's tables; most of their words stand in text/texts.txt.
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

/// Returns the answer of the benchmark: fixed sentences with numbers, the data of figure 6, and the
/// best formulations. The sentences have no measured ratio where a candidate of the case in front
/// has fewer than three repetitions.
Section answer(const Record& record);

/// Shows tables 1 and 2 of the paper for each sparse family recorded.
Section paper_tables(const Record& record);

/// Returns the data of figure 5, CPU time over coordinates: a row for each sparse solver and size.
Table figure_of_times(const Record& record);

/// Returns the data of figure 6, mean speed-up over the global formulation: a row for each variant.
Table figure_of_speed_ups(const Record& record);

/// Shows what several threads gain over one, by the wall clock: a table for each case.
Section threads(const Record& record);

/// Shows what it costs to solve only what a request asks, by the CPU clock: a table for each case
/// and size.
Section requests(const Record& record);

/// Shows what checking a run costs, for each step and at the start. Times of fewer than three
/// repetitions are left out.
Section checks(const Record& record);

/// Shows what peers take next to the formulations that start from the same guess: a table for each
/// case.
Section peers(const Record& record);

/// Shows all candidates by the CPU clock, the fastest first: a table for each case and size. Those
/// next to peers are left out.
Section every_formulation(const Record& record);

/// Shows how the time of a step divides into phases.
Table time_split(const Record& record);

// ---- accuracy ----

/// Returns the sections of the accuracy experiment, the short one first. The record must have
/// points at its own step.
std::vector<Section> accuracy_sections(const Record& record);

/// Returns the data of the work–precision figure of a motion: the solved configurations that the
/// figure draws, fastest first, then all that failed.
Table work_precision(const Record& record, const SeriesKey& series);

/// Shows the paper's speed-ups with other steps, tolerances and guesses.
Table sensitivity(const Record& record);

// ---- size, modelling, instructions, extremes ----

/// Returns the sections of time against size, the short one first. `growth` or `break_even` of the
/// record must not be empty.
std::vector<Section> size_sections(const Record& record);

/// Returns the sections of the paper's comparison in each kind of coordinates, the short one first.
/// `modelled` of the record must not be empty.
std::vector<Section> modelling_sections(const Record& record);

/// Returns the sections of instructions of a step, and of their ratio to the usual reference's, the
/// short one first. `instructions` of the record must not be empty.
std::vector<Section> instructions_sections(const Record& record);

/// Returns the sections of what formulations do in extreme cases, the short one first. `extremes`
/// of the record must not be empty.
std::vector<Section> extremes_sections(const Record& record);

// ---- about other commits, and about the record ----

/// Shows the history of instructions of a step, and lists the commits in which a candidate's count
/// changed by more than 2 %.
Section history_section(const History& history);

/// Shows the head of the record: when, on which machine, and how it was measured.
Table provenance(const Record& record);

/// Returns the section of what must not be concluded from the record.
Section limitations(const Record& record);

/// Returns a line, with the reason, for every candidate, request or peer of the paper's experiment
/// that failed.
std::vector<std::string> failures(const Record& record);

}  // namespace desmo::report
