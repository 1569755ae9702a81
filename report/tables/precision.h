// The parts of the report about time against error, one .cpp each: pure functions of the record.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/read/record.h"
#include "report/text/document.h"

namespace desmo::report {

/// Everything below, in sections. Empty when the record has no points. What is asked of a case by
/// name needs its main series (precision/selection.h).
std::vector<Section> precision_sections(const Record& record);

/// The data of the work–precision figure of a case at its largest size: every configuration solved
/// or failed, fastest first, with what is not applicable counted in a note.
Table work_precision(const Record& record, const std::string& case_name);

/// The cheapest configuration for each of the accuracies, and what it gains; and what it gives up.
Table accuracy_costs(const Record& record);
Table accuracy_errors(const Record& record);

/// The least time of every formulation for each of the accuracies: all with the same
/// guesses_and_updates; of those that solve every instant, or of all.
enum class Instants { solved, interpolated };
Table cheapest_by_formulation(const Record& record, const std::string& case_name,
                              Instants instants = Instants::solved);

/// Guesses × Jacobian updates of global_automatic_klu at an error of 1e-9, and a sentence on what
/// they gain.
Table guesses_and_updates(const Record& record);
std::vector<std::string> what_guesses_gain(const Record& record);

/// What float and mixed precision reach and what they cost, beside double.
Table scalars(const Record& record);

/// How many decades of error each formulation reaches at each size; and whether every one reaches
/// four, in a sentence.
Table error_levels(const Record& record, const std::string& case_name);
std::string min_levels(const Record& record);

/// How many configurations were tried, and of those without a time how many for which reason.
Table outcomes(const Record& record);

/// Condition numbers, the limits they predict, and how far the two references differ.
Table floors(const Record& record);
std::string max_floor(const Record& record);

/// Table 2 with other steps, tolerances and guesses.
Table sensitivity(const Record& record);

/// What the choices of desmo tune are worth. The record has promises.
Section tuning(const Record& record);

/// What it says of a failure before place and time: "singular Jacobian".
std::string kind_of_failure(std::string_view message);

}  // namespace desmo::report
