// Notes for users on where a run failed, and why.
#pragma once

#include <span>
#include <string>

#include "bench/cli/units.h"
#include "formulations/verification/run/checked_run.h"

namespace desmo::cli {

/// Returns "group 'SG-I' (crank, rod), constraint 'rod/length', t = 0.3 s: no position was found …;
/// at best 'rod/length' is off by 1.2 mm; <remedy>". Where the first instant failed, start_text()
/// is part of it.
/// - z: values of the drivers at the instant that failed; empty: those of their motions
std::string failure_text(const CheckedSummary& summary, const Model& model,
                         const DisplayUnits& units, std::span<const double> z = {});

/// Returns the failure that began a gap of a run, for failure_text().
CheckedSummary failure_of(const Gap& gap, const CheckedSummary& run);

/// Returns "; driver 's' starts at 0.2 mm, and is at 200 mm in the drawing", for at most three
/// drivers, the farthest from the drawing first; "" where all start as drawn.
/// - z: values of the drivers
std::string start_text(const Model& model, const DisplayUnits& units, std::span<const double> z);

/// Returns lines on the intervals that could not be assembled, if any.
std::string note_on_gaps(const CheckedSummary& summary, const Model& model,
                         const DisplayUnits& units);

/// Returns "column 'theta', t = 0.3 s: not a finite number …; <remedy>".
std::string overflow_text(const std::string& column, double time);

}  // namespace desmo::cli
