#pragma once

#include <ostream>
#include <vector>

#include "formulations/codegen/emit/explicit_plan.h"

namespace desmo::generate {

/// Writes the function `solve` of an explicit kernel, a template on value type and level. It
/// computes positions, residuals of the original equations, monitors and rates, section by section.
/// Returns the expressions of dimensions that it reads as elements of `f`.
std::vector<Expr> write_solve(std::ostream& out, const ExplicitPlan& plan);

}  // namespace desmo::generate
