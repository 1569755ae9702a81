#pragma once

#include <vector>

#include "formulations/settings.h"

namespace desmo::precision {

/// Settings that end at errors of different sizes in every formulation, few of them: the paper's
/// with one, two and three iterations a step from different guesses, and with its tolerance.
std::vector<Settings> few_settings();

/// Guesses × Jacobian updates × where to stop (tolerances and numbers of iterations), in double
/// precision; single and mixed precision with the paper's guess and the best one.
std::vector<Settings> all_settings();

}  // namespace desmo::precision
