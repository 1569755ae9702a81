// Why what is solved is solved, and what is not.
#pragma once

#include <string>

#include "formulations/planning/plan.h"

namespace desmo::cli {

/// Group by group: what a plan keeps, as far as which level, for whom, and what it drops.
std::string explain(const Plan& plan, const Model& whole);

}  // namespace desmo::cli
