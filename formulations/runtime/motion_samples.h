#pragma once

#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/model/model.h"

namespace desmo::load {

/// Some states of a mechanism (q, then the fixed values) spread over its motion, for a generator to
/// look at: approximate, and in steps so large that another branch than the motion's may be met.
/// Where it cannot be followed it ends; none when it cannot be assembled.
std::vector<std::vector<double>> sample_motion(const Model& model, const TimeGrid& grid);

}  // namespace desmo::load
