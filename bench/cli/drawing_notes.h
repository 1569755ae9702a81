// Notes for users on what a drawing means that they may not have meant.
#pragma once

#include <string>

#include "bench/cli/units.h"
#include "cases/mechanism/mechanism.h"
#include "formulations/model/model.h"

namespace desmo::cli {

/// Returns a line for each point whose drawn offset from its joint is kept: from the line of a
/// revolute_on_slider, or from the plane of a point_on_plane. Where no body has a frame or a length
/// of its own, adds one for each coupling whose table contradicts the drawing. Returns "" where
/// there is nothing to note. model: that of the whole mechanism.
std::string note_on_drawing(const Mechanism& mechanism, const Model& model,
                            const DisplayUnits& units);

}  // namespace desmo::cli
