// Explanation of what a plan solves and what it omits.
#pragma once

#include <string>

#include "formulations/planning/plan.h"

namespace desmo::cli {

/// Returns lines by group: what a plan keeps, to which level, for which entity, and what it drops.
std::string explain(const Plan& plan, const Model& whole);

}  // namespace desmo::cli
