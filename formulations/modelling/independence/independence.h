#pragma once

#include <vector>

#include "formulations/modelling/modelling.h"

namespace desmo {

/// Leaves out dependent scalar equations (sets Constraint::left_out), so that each group has as
/// many equations as unknowns. LeftOutEquations checks those left out.
///
/// Equations are selected in this order: derivations first, then linear ones, then by number of
/// entries, by EquationSource, by position. An equation is left out if its gradient by the group's
/// unknowns depends on those selected before. Rank may be lower at a special position. Therefore
/// the nominal and two perturbed positions are assembled, and the one of highest rank decides. In a
/// group that closes only to the digits of its file, gradients that differ by ≤ max_misfit count as
/// dependent. Where only one of a definition's equations is selected, its ScalarDefinition replaces
/// the definition, unless the rank then falls.
///
/// surplus: for each group, restrictions minus freedoms.
/// Throws std::invalid_argument, naming group, bodies and equations, when
/// - the nominal position cannot be assembled,
/// - an equation between constants is off by more than 1e-4 of its length,
/// - a group is under-constrained,
/// - a group cannot follow its drivers: there are too many, or constraints contradict each other
///   by more than 1e-4 of its size.
std::vector<LeftOut> leave_out_dependent(Model& candidates, const std::vector<int>& surplus);

}  // namespace desmo
