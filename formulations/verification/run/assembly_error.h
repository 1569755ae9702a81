#pragma once

#include <optional>
#include <vector>

#include "formulations/model/misfit.h"
#include "formulations/model/model.h"

namespace desmo {

/// Returns the assembly error of the first group that cannot be assembled. It is the misfit of the
/// worst equation at the position that satisfies all equations best. Returns nothing if all groups
/// can be assembled, even in a singular position: ‖Φ‖₂ of their weighted equations is below
/// default_tolerance, whatever tolerance a run accepts. Levenberg and Marquardt's method minimises
/// the sum of squares of (equation / its magnitude). Allocates: keep it out of timed code.
/// - state: start of the search: the last solved instant, with the drivers of the failed one
std::optional<Misfit> find_assembly_error(const Model& model, std::vector<double> state);

}  // namespace desmo
