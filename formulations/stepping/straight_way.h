#pragma once

#include <functional>
#include <span>
#include <vector>

#include "formulations/base/part.h"
#include "formulations/model/model.h"

namespace desmo {

/// How far each driver has to go, straight, from a state to where it is at time t: whole turns more
/// do not make another way.
std::vector<double> straight_way(const Model& model, const State& from, double t);

/// A way is cut into so many pieces.
inline constexpr int pieces_of_a_way = 8;

/// Takes a state from where it is solved to where the drivers are at time t, give or take whole
/// turns, along the way on which they go straight: how an instant in the middle of a motion is
/// reached without all those before it. solve: solves the positions of a state for those of its
/// drivers, given those reached before, and says whether it could; first where the state is, so
/// that it may find its branches. False where the way cannot be gone; the state is then somewhere
/// on it. Not for timed loops.
bool go_straight(const Model& model, double t, State& state,
                 const std::function<bool(State&, std::span<const double> last)>& solve);

}  // namespace desmo
