// Notes for users on what a drawing means that they may not have meant.
#pragma once

#include <string>

#include "bench/cli/units.h"
#include "cases/mechanism/mechanism.h"
#include "formulations/model/model.h"

namespace desmo::cli {

/// Returns lines on points that joints keep where they are drawn, off the line or plane that they
/// slide on, and on tables that do not lead through the drawing; nothing if there are none.
/// model: that of the whole mechanism
std::string note_on_drawing(const Mechanism& mechanism, const Model& model,
                            const DisplayUnits& units);

}  // namespace desmo::cli
