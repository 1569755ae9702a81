// Notes for users on a formulation and its run.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/cli/units.h"
#include "formulations/planning/plan.h"
#include "formulations/variants.h"
#include "formulations/verification/monitor/monitored_run.h"

namespace desmo::cli {

/// Returns lines by group: what a plan keeps, to which level, for which entity, and what it drops.
std::string explain(const Plan& plan, const Model& whole);

/// Returns a line when parts lack the generated code that the formulation's id promises, else
/// nothing. named: whether the user has chosen the formulation.
std::string note_on_code(const Formulation& formulation, bool named);

/// Returns a line on steps that generated code refused, what that cost, and their branches; else
/// nothing. named: whether the user has chosen the formulation.
std::string note_on_refusals(const Formulation& formulation, bool named);

/// Returns a line when the id asks for segments of the motion but it was solved step by step; else
/// nothing.
std::string note_on_steps(const Formulation& formulation);

/// Returns a line when a stride was halved; else nothing.
std::string note_on_stride(const MonitoredSummary& summary, const Formulation& formulation);

/// Returns a line when rounding prevents the requested tolerance; else nothing.
std::string note_on_tolerance(const Formulation& formulation, double asked);

/// Returns the accuracy of the results: a line on condition number and bounds. Further lines name
/// degraded instants and a singular position that was passed, if any.
std::string note_on_accuracy(const MonitoredSummary& summary, Level level, const Model& model,
                             const DisplayUnits& units);

/// Returns these further lines alone: of a run that failed, what was flagged before.
std::string note_on_flags(const MonitoredSummary& summary, Level level, const Model& model);

/// Returns why a strict run ended, in the form of failure_text().
std::string refusal_text(const MonitoredSummary& summary, Level level, const Model& model);

/// Returns "group 'SG-I' (crank, rod), constraint 'rod/length', t = 0.3 s: no position was found …;
/// at the nearest to it 'rod/length' is off by 1.2 mm; <remedy>". Where the first instant failed,
/// it says what start_text() does.
/// - z: values of the drivers at the instant that failed; empty: those of their motions
std::string failure_text(const MonitoredSummary& summary, const Model& model,
                         const DisplayUnits& units, std::span<const double> z = {});

/// Returns "; driver 's' starts at 0.2 mm, and is at 200 mm in the drawing", for at most three
/// drivers, the farthest from the drawing first; "" where all start as drawn.
/// - z: values of the drivers
std::string start_text(const Model& model, const DisplayUnits& units, std::span<const double> z);
/// Returns the drivers' values of their motions at a time.
std::vector<double> driver_values(const Model& model, double time);

/// Return why an instant is degraded and what an interval crosses: "group 'SG-I' (crank, rod), t =
/// 0.3 s: …".
std::string degradation_text(const Degradation& degradation, Level level, const Model& model);
std::string crossing_text(const SingularityCrossing& crossing, const Model& model);

/// Returns a word for the flag of an instant: "branch" where it lies, or may lie, on another than
/// before, "crossing" after a singular position, "degraded"; none: "".
std::string_view flag_of(const MonitoredInstant& instant);

/// Returns lines on the intervals that could not be assembled, if any.
std::string note_on_gaps(const MonitoredSummary& summary, const Model& model,
                         const DisplayUnits& units);

/// Returns "column 'theta', t = 0.3 s: not a finite number …; <remedy>".
std::string overflow_text(const std::string& column, double time);

}  // namespace desmo::cli
