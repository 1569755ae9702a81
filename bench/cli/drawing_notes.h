// Notes for users on what a drawing means that they may not have meant.
#pragma once

#include <string>

#include "bench/cli/units.h"
#include "cases/mechanism/mechanism.h"
#include "formulations/model/model.h"

namespace desmo::cli {

/// Returns a line for each point drawn off the line of its revolute_on_slider or the plane of its
/// point_on_plane joint, since that offset is kept. Where no body has a frame or a length of its
/// own, also returns one for each coupling whose table contradicts the drawing. Empty if there is
/// none. model: that of the whole mechanism
std::string note_on_drawing(const Mechanism& mechanism, const Model& model,
                            const DisplayUnits& units);

}  // namespace desmo::cli
