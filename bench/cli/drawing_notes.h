// Notes for users on what a drawing means that they may not have meant.
#pragma once

#include <string>

#include "bench/cli/units.h"
#include "cases/mechanism/mechanism.h"
#include "formulations/model/model.h"

namespace desmo::cli {

/// Returns a line for each point drawn off the line of its revolute_on_slider or the plane of its
/// point_on_plane joint, since that offset is kept. Where all bodies are drawn, also one for each
/// table that does not lead through the drawing. Empty if there is none. model: of the whole
/// mechanism
std::string note_on_drawing(const Mechanism& mechanism, const Model& model,
                            const DisplayUnits& units);

}  // namespace desmo::cli
