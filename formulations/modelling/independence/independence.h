#pragma once

#include <string>
#include <vector>

#include "formulations/modelling/equations/candidates.h"
#include "formulations/modelling/modelling.h"

namespace desmo {

/// Leaves out of the candidates (Constraint::left_out; BranchMonitor watches what is left out)
/// those scalar equations that depend on others, so that each group has as many equations as
/// unknowns.
///
/// Equations are taken in this order: linear ones first, then those with the fewest entries, then
/// by Origin, then as they stand. One is left out if it depends on those taken before, in the
/// unknowns of its group. A special pose deceives: this is judged where the group has the highest
/// rank, of the nominal position and two perturbed ones, each assembled. A definition of several
/// equations of which one is taken is replaced by its ScalarDefinition.
///
/// surplus: for each group, restrictions beyond its freedoms.
/// Throws std::invalid_argument, naming group, bodies and equations, when the nominal position
/// cannot be assembled, when a group is left under-constrained, and when it cannot follow its
/// drivers (too many drivers, contradictory constraints: with what they are off by at best).
std::vector<LeftOut> leave_out_dependent(Candidates& candidates, const std::vector<int>& surplus);

}  // namespace desmo
