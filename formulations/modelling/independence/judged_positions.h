#pragma once

#include <array>
#include <vector>

#include "formulations/modelling/independence/linearisation.h"

namespace desmo {

/// States at which the dependence of equations is judged: the nominal position, then perturbed
/// ones.
using JudgedPositions = std::array<std::vector<double>, 3>;

/// Assembles them, each group over unknowns and drivers; where a perturbed one cannot be
/// assembled, it is the nominal one. Throws std::invalid_argument, naming group, bodies and
/// constraint, when the nominal position cannot be assembled.
JudgedPositions assemble_positions(const Model& model, const std::vector<GroupSystem>& systems,
                                   Lineariser& lineariser);

}  // namespace desmo
