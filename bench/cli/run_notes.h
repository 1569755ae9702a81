// What a user should know of a formulation and of its run.
#pragma once

#include <string>

#include "formulations/variants.h"
#include "formulations/verification/monitor/monitored_run.h"

namespace desmo::cli {

/// A line when parts lack the generated code that the formulation's id promises; otherwise empty.
/// named: the user has chosen the formulation.
std::string note_on_code(const Formulation& formulation, bool named);

/// A line when generated code refused steps, and on which branches they came out; otherwise empty.
std::string note_on_refusals(const Formulation& formulation);

/// A line when the id asks for segments of the motion and it was solved step by step after all;
/// otherwise empty.
std::string note_on_steps(const Formulation& formulation);

/// A line when rounding leaves more of the equations than the tolerance that was asked for;
/// otherwise empty.
std::string note_on_tolerance(const Formulation& formulation, double asked);

/// How right the results are: a line on condition number and bounds, and one each on degraded
/// instants and on a singular position that was passed, if any.
std::string note_on_accuracy(const MonitoredSummary& summary, Level level, const Model& model);

/// Why a strict run ended: as failure_text.
std::string refusal_text(const MonitoredSummary& summary, Level level, const Model& model);

/// "group 'SG-I' (crank, rod), constraint 'rod/length', t = 0.3 s: no position was found …;
/// at the nearest to it 'rod/length' is off by 1.2e-03 m; <remedy>"
std::string failure_text(const MonitoredSummary& summary, const Model& model);

/// Lines on the intervals that could not be assembled, if any.
std::string note_on_gaps(const MonitoredSummary& summary, const Model& model);

/// "column 'theta', t = 0.3 s: not a finite number …; <remedy>"
std::string overflow_text(const std::string& column, double time);

}  // namespace desmo::cli
