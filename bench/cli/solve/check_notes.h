// Notes for users on what is proven of a run, and what is flagged.
#pragma once

#include <string>

#include "bench/cli/units.h"
#include "formulations/verification/run/checked_run.h"

namespace desmo::cli {

/// Returns the accuracy of the results: a line on how many rows are proven, the condition number
/// and the largest radii, and the lines of note_on_flags(). check: what was to be proven; with
/// CheckMode::none, returns a line that says that nothing is.
std::string note_on_proofs(const CheckedSummary& summary, const CheckOptions& check,
                           const Model& model, const DisplayUnits& units);

/// Returns a line each on flagged rows, on the first change point unless the first flag is of it,
/// on the largest contradiction, and on the number of change points if several; "" if there are
/// none.
std::string note_on_flags(const CheckedSummary& summary, const Model& model,
                          const DisplayUnits& units);

/// Returns why a row is flagged: "group 'SG-I' (crank, rod), t = 0.3 s: …".
std::string flag_text(const RowFlag& flag, const Model& model, const DisplayUnits& units);

/// Returns "'rod/length' is off by 1.2 mm"; without a unit where a direction is off.
std::string off_by(const Misfit& misfit, const Model& model, const DisplayUnits& units);

/// Returns why a strict run ended, in the form of failure_text().
std::string refusal_text(const CheckedSummary& summary, const Model& model,
                         const DisplayUnits& units);

}  // namespace desmo::cli
