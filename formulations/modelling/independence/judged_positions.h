#pragma once

#include <array>
#include <vector>

#include "formulations/modelling/independence/linearisation.h"

namespace desmo {

/// The states at which the dependence of equations is judged: the nominal position, then two
/// perturbed ones.
using JudgedPositions = std::array<std::vector<double>, 3>;

/// Assembles these positions. Each group may move its unknowns and its drivers. A perturbed
/// position that cannot be assembled is replaced by the nominal one. Throws std::invalid_argument,
/// naming group, bodies and constraint, when the nominal position cannot be assembled.
JudgedPositions assemble_positions(const Model& model, const std::vector<GroupSystem>& systems,
                                   Lineariser& lineariser);

}  // namespace desmo
