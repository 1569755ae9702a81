#pragma once

#include <functional>
#include <span>
#include <vector>

#include "formulations/base/state.h"
#include "formulations/model/model.h"

namespace desmo {

/// Returns how far each driver has to move from one state to where another has it. Whole turns of
/// angles are left out, unless couplings count them.
std::vector<double> driver_changes(const Model& model, const State& from, const State& to);

/// Returns the number of steps of a continuation, if no step fails. changes: of the drivers, by
/// driver_changes(). Where couplings count whole turns, and where steps are to be short, drivers
/// turn by at most 0.1 rad in a step.
int continuation_steps(const Model& model, std::span<const double> changes, bool are_short = false);

/// Maximum number of steps of a continuation (≤): some 16,000 turns, or a second of computing time
/// for a small mechanism.
inline constexpr int max_continuation_steps = 1000000;

/// The outcome of a continuation.
enum class ContinuationEnd {
  reached,
  blocked,
  too_long,  ///< it would take more than max_continuation_steps steps
};

/// Moves the drivers of a solved state linearly, by driver_changes(), to where another state has
/// them. So an instant within a motion is reached without those before it.
/// - to: its drivers alone are read
/// - state: solved; overwritten, on failure with a position on the way
/// - solve: solves the positions of a state for its drivers, given the last positions; returns
///   whether it could. The first call is at the state itself, to find its branches
/// - are_short: see continuation_steps()
/// A failed step is halved, down to a sixteenth. Where more than max_continuation_steps would be
/// needed, turns that lead back (is_back()) are left out first. Where the way without whole turns
/// is blocked, the way with them is tried, unless it takes more than max_continuation_steps. Not
/// for timed loops.
ContinuationEnd continue_drivers_to(
    const Model& model, const State& to, State& state,
    const std::function<bool(State&, std::span<const double> last)>& solve, bool are_short = false);

}  // namespace desmo
