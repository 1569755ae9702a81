#pragma once

#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/model/model.h"

namespace desmo::load {

/// Returns a grid over the same time, of at most 400 steps.
TimeGrid with_few_steps(TimeGrid grid);

/// Returns states of a model (q, then the fixed values) spread over its motion, as samples for code
/// generation. They are approximate, and large steps may reach another branch than the motion's.
/// The list ends where the motion cannot be followed; it is empty when the model cannot be
/// assembled.
std::vector<std::vector<double>> sample_motion(const Model& model, const TimeGrid& grid);

}  // namespace desmo::load
