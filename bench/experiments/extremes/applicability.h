#pragma once

#include <string>

#include "bench/experiments/extremes/problem.h"
#include "formulations/formulation.h"
#include "formulations/id.h"

namespace desmo::extremes {

/// Why a formulation is not tried on a problem that has a model, in a sentence without a full stop;
/// empty: it is. What it does not offer, or what would take too long.
std::string why_not_tried(const Configuration& configuration, const Problem& problem);

/// The same for a formulation that would not be the one that its id names.
std::string lacks_generated_code(const Formulation& formulation);

}  // namespace desmo::extremes
