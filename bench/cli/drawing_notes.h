// Notes for users on what a drawing means that they may not have meant.
#pragma once

#include <string>

#include "bench/cli/units.h"
#include "cases/mechanism/mechanism.h"
#include "formulations/model/model.h"

namespace desmo::cli {

/// Returns a line for each joint whose point is drawn off the line or plane that it slides on,
/// since that offset is kept, and for each table that does not lead through the drawing; empty if
/// there is none. model: that of the whole mechanism
std::string note_on_drawing(const Mechanism& mechanism, const Model& model,
                            const DisplayUnits& units);

}  // namespace desmo::cli
