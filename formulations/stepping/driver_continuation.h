#pragma once

#include <functional>
#include <span>
#include <vector>

#include "formulations/base/state.h"
#include "formulations/model/model.h"

namespace desmo {

/// Returns how far each driver has to move from a state to where it is at time t [s]. Whole turns
/// are left out.
std::vector<double> driver_changes(const Model& model, const State& from, double t);

/// Steps of a continuation that goes well.
inline constexpr int continuation_steps = 8;

/// Moves the drivers of a solved state in proportion to where they are at time t [s], give or take
/// whole turns: how an instant in the middle of a motion is reached without those before it. solve:
/// solves the positions of a state for its drivers, given the last ones, and returns whether it
/// could; it is first called where the state is, to find its branches. A step that cannot be solved
/// is halved. Where that leads nowhere, whole turns are made. Returns false where t cannot be
/// reached; the state is then on the way. Not for timed loops.
bool continue_drivers_to(const Model& model, double t, State& state,
                         const std::function<bool(State&, std::span<const double> last)>& solve);

}  // namespace desmo
