#pragma once

#include <ostream>
#include <vector>

#include "formulations/codegen/emit/explicit_plan.h"

namespace desmo::generate {

/// Writes `solve`, a template on the value type and the level, of an explicit kernel: section after
/// section its positions, the original equations and the monitors as soon as all they read is
/// there, and its rates. Returns the expressions of dimensions that it reads as elements of `f`.
std::vector<Expr> write_solve(std::ostream& out, const ExplicitPlan& plan);

}  // namespace desmo::generate
